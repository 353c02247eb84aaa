package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.network.CommunicationSetting;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.Quirk;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.files.ParameterFile;
import picocli.CommandLine.Option;

/** The options of CamSim that choose how its network works (behaviour 12.1). */
final class CamSimOptions {
  @Option(
      names = {"-a", "--algo"},
      paramLabel = "CLASS")
  private Optional<String> schedule;

  @Option(
      names = {"-c", "--comm"},
      paramLabel = "0..4")
  private Optional<String> comm;

  @Option(
      names = {"-u", "--custom-comm"},
      paramLabel = "CLASS")
  private Optional<String> customComm;

  @Option(names = "--strategies", paramLabel = "A0-P2-...")
  private Optional<String> strategies;

  @Option(
      names = {"-b", "--bandit"},
      paramLabel = "CLASS")
  private Optional<String> bandit;

  @Option(
      names = {"-v", "--vg"},
      paramLabel = "-1..2")
  private int graph;

  @Option(
      names = {"-e", "--camerr"},
      paramLabel = "N")
  private int errorLevel;

  @Option(
      names = {"-r", "--camreset"},
      paramLabel = "N")
  private int resetLevel;

  @Option(names = {"-g", "--global"})
  @SuppressWarnings("UnusedVariable") // accepted for compatibility with CamSim
  private boolean global;

  @Option(
      names = {"-p", "--paramfile"},
      paramLabel = "FILE")
  private Optional<Path> parameters;

  @Option(names = "--quirks", paramLabel = "all|none|NAME,...")
  private String quirks;

  /** Reads the options, with warnings on {@code err}. */
  NetworkSettings settings(PrintWriter err) {
    ParameterFile file = parameters.map(ParameterFile::read).orElse(ParameterFile.DEFAULT);
    if (strategies.isPresent() && (schedule.isPresent() || comm.isPresent())) {
      throw new InputException("--strategies is given with -a or -c, expected one of them");
    }
    return new NetworkSettings(
        strategies.map(Strategy::parse).orElse(List.of()),
        named(ScheduleKind.class, "-a", schedule),
        comm(err),
        named(BanditAlgorithm.class, "-b", bandit),
        GraphUse.find(graph)
            .orElseThrow(
                () -> new InputException("-v is " + graph + ", expected one of -1, 0, 1, 2")),
        errorLevel,
        resetLevel,
        file.bandit(),
        file.historical(),
        quirks());
  }

  private static <E extends Enum<E> & Named> Optional<E> named(
      Class<E> type, String option, Optional<String> name) {
    return name.map(
        text ->
            Named.find(type, text).orElseThrow(() -> invalid(option, text, Named.expected(type))));
  }

  private static InputException invalid(String option, String text, String expected) {
    return new InputException("%s is '%s', expected %s".formatted(option, text, expected));
  }

  /** Reads option -c; as in CamSim, the scenario file decides if the value is not a number. */
  private Optional<CommunicationSetting> comm(PrintWriter err) {
    if (comm.isEmpty()) {
      return Optional.empty();
    }
    try {
      int number =
          Numbers.inRange(
              "-c", Integer.parseInt(comm.get().strip()), 0, CommunicationSetting.CUSTOM);
      return Optional.of(
          CommunicationSetting.of(number, customComm).orElseThrow(this::invalidPolicy));
    } catch (NumberFormatException e) {
      err.println(
          "warning: -c '" + comm.get() + "' is no number: each camera's own policy is taken");
      return Optional.empty();
    }
  }

  private InputException invalidPolicy() {
    return invalid(
        "-u", customComm.orElse(""), Named.expected(CommunicationPolicy.class) + " where -c is 4");
  }

  private Set<Quirk> quirks() {
    return switch (quirks) {
      case "all" -> EnumSet.allOf(Quirk.class);
      case "none" -> EnumSet.noneOf(Quirk.class);
      default ->
          Arrays.stream(quirks.split(","))
              .map(name -> quirk(name.strip()))
              .collect(Collectors.toSet());
    };
  }

  private static Quirk quirk(String name) {
    return Quirk.find(name)
        .orElseThrow(
            () ->
                InputException.of(
                    "--quirks names '%s', expected all, none, or some of %s",
                    name, Spelling.all(Quirk.class)));
  }
}
