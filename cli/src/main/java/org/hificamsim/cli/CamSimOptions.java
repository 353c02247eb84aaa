package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.network.GraphUse;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Quirk;
import org.hificamsim.network.files.ParameterFile;
import picocli.CommandLine.Option;

/** CamSim's own options that say how the network is run (behaviour 12.1). */
final class CamSimOptions {
  private static final int MAX_COMM = 4;

  @Option(
      names = {"-a", "--algo"},
      paramLabel = "CLASS",
      description = "Auction schedule of all cameras: Active, Passive, HistActive, ...")
  private Optional<String> schedule;

  @Option(
      names = {"-c", "--comm"},
      paramLabel = "0..4",
      description = "Policy of all cameras: 0 Broadcast, 1 Smooth, 2 Step, 3 Fix, 4 see -u.")
  private Optional<String> comm;

  @Option(
      names = {"-u", "--custom-comm"},
      paramLabel = "CLASS",
      description = "The policy where -c is 4.")
  private Optional<String> customComm;

  @Option(
      names = {"-b", "--bandit"},
      paramLabel = "CLASS",
      description = "Bandit of all cameras: EpsilonGreedy, UCB1, UCB2, UCBTuned, SoftMax, ...")
  private Optional<String> bandit;

  @Option(
      names = {"-v", "--vg"},
      paramLabel = "-1..2",
      description = "Vision graph: -1 as in the file, 0 static, 1 ignored, 2 not static.")
  private int graph;

  @Option(
      names = {"-e", "--camerr"},
      paramLabel = "N",
      description = "A camera fails in N + 1 percent of the steps.")
  private int errorLevel;

  @Option(
      names = {"-r", "--camreset"},
      paramLabel = "N",
      description = "A failing camera forgets its neighbours in 99 - N percent of the cases.")
  private int resetLevel;

  @Option(
      names = {"-g", "--global"},
      description = "Global registration; changes no number.")
  @SuppressWarnings("UnusedVariable") // understood for CamSim's sake
  private boolean global;

  @Option(
      names = {"-p", "--paramfile"},
      paramLabel = "FILE",
      description = "Properties file: Epsilon, Alpha, ObjectCategories, ...")
  private Optional<Path> parameters;

  @Option(
      names = "--quirks",
      paramLabel = "all|none|Q3,...",
      description = "Which of CamSim's quirks Q3, Q5, Q6, Q14, Q17, Q19 are reproduced.")
  private String quirks;

  /** Reads the options, with warnings on {@code err}. */
  NetworkSettings settings(PrintWriter err) {
    ParameterFile file = parameters.map(ParameterFile::read).orElseGet(ParameterFile::none);
    return new NetworkSettings(
        schedule,
        comm(err),
        customComm,
        bandit,
        GraphUse.find(graph)
            .orElseThrow(
                () -> new InputException("-v is " + graph + ", expected one of -1, 0, 1, 2")),
        errorLevel,
        resetLevel,
        file.bandit(),
        file.historical(),
        quirks());
  }

  /** As in CamSim, what is no number leaves it to the file. */
  private OptionalInt comm(PrintWriter err) {
    if (comm.isEmpty()) {
      return OptionalInt.empty();
    }
    try {
      return OptionalInt.of(
          Numbers.inRange("-c", Integer.parseInt(comm.get().strip()), 0, MAX_COMM));
    } catch (NumberFormatException e) {
      err.println(
          "warning: -c '" + comm.get() + "' is no number: each camera's own policy is taken");
      return OptionalInt.empty();
    }
  }

  private Set<Quirk> quirks() {
    return switch (quirks) {
      case "all" -> EnumSet.allOf(Quirk.class);
      case "none" -> EnumSet.noneOf(Quirk.class);
      default -> {
        Set<Quirk> some = EnumSet.noneOf(Quirk.class);
        for (String name : quirks.split(",")) {
          some.add(quirk(name.strip()));
        }
        yield some;
      }
    };
  }

  private static Quirk quirk(String name) {
    return Arrays.stream(Quirk.values())
        .filter(quirk -> quirk.name().equalsIgnoreCase(name))
        .findFirst()
        .orElseThrow(
            () ->
                new InputException(
                    "--quirks names '%s', expected all, none, or some of %s"
                        .formatted(name, Arrays.toString(Quirk.values()))));
  }
}
