package org.hificamsim.network.files;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.registry.Options;
import org.hificamsim.network.Comm;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.Quirk;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;

/** How a network is run as one text, {@code camsim:strategies=A0-P2,...}: what a plan holds. */
public final class NetworkText {
  /** The name of CamSim's network. */
  public static final String NAME = "camsim";

  private static final String NONE = "";

  private NetworkText() {}

  /** The text of settings: what differs from CamSim's defaults. */
  public static String of(NetworkSettings settings) {
    NetworkSettings usual = NetworkSettings.CAMSIM;
    Stream<String> own =
        Stream.of(
            part("strategies", Strategy.text(settings.strategies()), NONE),
            part("schedule", settings.schedule().map(one -> one.names().get(0)).orElse(NONE), NONE),
            part("comm", settings.comm().map(Comm::text).orElse(NONE), NONE),
            part("bandit", settings.bandit().map(one -> one.names().get(0)).orElse(NONE), NONE),
            part("graph", Spelling.of(settings.graph()), Spelling.of(usual.graph())),
            part("errors", settings.errorLevel(), usual.errorLevel()),
            part("resets", settings.resetLevel(), usual.resetLevel()),
            part("quirks", quirks(settings.quirks()), quirks(usual.quirks())));
    String all =
        Stream.concat(own, ParameterFile.texts(settings).stream())
            .filter(text -> !text.isEmpty())
            .collect(Collectors.joining(","));
    return all.isEmpty() ? NAME : NAME + ":" + all;
  }

  private static String part(String key, Object value, Object usual) {
    return value.equals(usual) ? NONE : key + "=" + value;
  }

  private static String quirks(Set<Quirk> quirks) {
    return quirks.isEmpty()
        ? "none"
        : quirks.stream().sorted().map(Spelling::of).collect(Collectors.joining("+"));
  }

  /**
   * The settings of a text.
   *
   * @throws InputException when something is wrong in it
   */
  static NetworkSettings settings(Options options) {
    String strategies = options.text("strategies", NONE, "of all cameras, or of each");
    String schedule = options.text("schedule", NONE, "of all cameras");
    String comm = options.text("comm", NONE, "number or class of the policy of all cameras");
    String bandit = options.text("bandit", NONE, "of all cameras");
    GraphUse graph = options.choice("graph", GraphUse.AS_IN_FILE, "what the vision graph is for");
    int errors = options.integer("errors", -1, Integer.MIN_VALUE, Integer.MAX_VALUE, "as -e");
    int resets = options.integer("resets", 50, Integer.MIN_VALUE, Integer.MAX_VALUE, "as -r");
    Set<Quirk> quirks = quirks(options.text("quirks", quirks(EnumSet.allOf(Quirk.class)), "kept"));
    ParameterFile parameters = ParameterFile.of(options);
    return new NetworkSettings(
        strategies.isEmpty() ? List.of() : Strategy.list(strategies),
        named(ScheduleKind.class, "schedule", schedule),
        comm.isEmpty() ? Optional.empty() : Comm.parse(comm),
        named(BanditAlgorithm.class, "bandit", bandit),
        graph,
        errors,
        resets,
        parameters.bandit(),
        parameters.historical(),
        quirks);
  }

  private static <E extends Enum<E> & Named> Optional<E> named(
      Class<E> type, String key, String text) {
    return text.isEmpty()
        ? Optional.empty()
        : Optional.of(
            Named.find(type, text)
                .orElseThrow(
                    () ->
                        new InputException(
                            "network: %s is '%s', expected %s"
                                .formatted(key, text, Named.expected(type)))));
  }

  private static Set<Quirk> quirks(String text) {
    Set<Quirk> quirks = EnumSet.noneOf(Quirk.class);
    if (!text.equals("none")) {
      Arrays.stream(text.split("\\+"))
          .map(name -> Spelling.require(Quirk.class, "quirks", name))
          .forEach(quirks::add);
    }
    return quirks;
  }
}
