package org.hificamsim.cli;

import java.util.Locale;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.Scenario;

/** One-line descriptions for people. */
final class Descriptions {
  private Descriptions() {}

  /** What a scenario holds. */
  static String of(Scenario scenario) {
    return String.format(
        Locale.ROOT,
        "%s, %s, %s, field %s x %s m, %s, %s order",
        count(scenario.cameras().size(), "camera"),
        count(scenario.targets().size(), "target"),
        count(scenario.events().size(), "event"),
        plain(scenario.field().width()),
        plain(scenario.field().height()),
        views(scenario),
        Spelling.of(scenario.order()));
  }

  /** Old files say it as ever. */
  private static String views(Scenario scenario) {
    long optics =
        scenario.cameras().stream().flatMap(one -> one.optics().stream()).distinct().count();
    if (optics > 0) {
      int obstacles = scenario.obstacles().size();
      return optics
          + (optics == 1 ? " kind" : " kinds")
          + " of optics, "
          + count(obstacles, "obstacle");
    }
    return scenario.inCoverageDialect()
        ? count(scenario.zooms().size(), "zoom level")
        : "one zoom level (no <zoom> list)";
  }

  private static String count(int number, String noun) {
    return number + " " + noun + (number == 1 ? "" : "s");
  }

  private static String plain(double value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }
}
