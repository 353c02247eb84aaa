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
        scenario.inCoverageDialect()
            ? count(scenario.zooms().size(), "zoom level")
            : "one zoom level (no <zoom> list)",
        Spelling.of(scenario.order()));
  }

  private static String count(int number, String noun) {
    return number + " " + noun + (number == 1 ? "" : "s");
  }

  private static String plain(double value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }
}
