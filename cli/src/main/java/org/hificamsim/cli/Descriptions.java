package org.hificamsim.cli;

import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;

/** Describes scenarios for people in one line. */
final class Descriptions {
  private Descriptions() {}

  /** Describes the contents of a scenario. */
  static String of(Scenario scenario) {
    return Texts.format(
        "%s, %s, %s, field %s x %s m, %s, %s order",
        Texts.counted(scenario.cameras().size(), "camera"),
        targets(scenario),
        Texts.counted(scenario.events().size(), "event"),
        plain(scenario.field().width()),
        plain(scenario.field().height()),
        views(scenario),
        Spelling.of(scenario.order()));
  }

  /** Describes the targets. A recorded target counts once, however often it appears. */
  private static String targets(Scenario scenario) {
    List<TargetSpec> recorded =
        scenario
            .events(ScenarioEvent.AddTarget.class)
            .map(ScenarioEvent.AddTarget::target)
            .filter(target -> target.track().isPresent())
            .toList();
    String others = Texts.counted(scenario.targets().size(), "target");
    long samples =
        recorded.stream().mapToLong(target -> target.track().orElseThrow().samples()).sum();
    int count = (int) recorded.stream().map(TargetSpec::features).distinct().count();
    String found = Texts.format("%,d samples of %s", samples, Texts.counted(count, "target"));
    return recorded.isEmpty()
        ? others
        : scenario.targets().isEmpty() ? found : others + ", " + found;
  }

  /** Describes the optics and obstacles, or the zoom levels of a scenario without optics. */
  private static String views(Scenario scenario) {
    long optics =
        scenario.cameras().stream().flatMap(camera -> camera.optics().stream()).distinct().count();
    if (optics > 0) {
      String kinds = Texts.counted(optics, "kind") + " of optics, ";
      return kinds + Texts.counted(scenario.obstacles().size(), "obstacle");
    }
    return scenario.inCoverageDialect()
        ? Texts.counted(scenario.zooms().size(), "zoom level")
        : "one zoom level (no <zoom> list)";
  }

  private static String plain(double value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }
}
