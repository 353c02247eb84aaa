package org.hificamsim.tracks;

import java.util.regex.Matcher;
import org.hificamsim.core.Place;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;

/** The objective and detection of scenarios that are made of files. */
final class SiteQuestion {
  private static final String DETECTION = "oodpcvs-2025:level=discern";

  /** The pixel density that this detection needs. */
  static final double PIXELS_PER_METRE = 80;

  private static final String OBJECTIVE = "covered:k=1";

  private SiteQuestion() {}

  /** A scenario with walls, a floor plan and the question, but without cameras and targets. */
  static Scenario about(SiteSettings settings, Field field) {
    Scenario empty =
        new Scenario(settings.name(), field)
            .with(Scenario.ORDER, StepOrder.COVERAGE)
            .with(Scenario.DETECTION, DETECTION)
            .with(Scenario.OBJECTIVE, Objective.parse(OBJECTIVE))
            .with(Scenario.OBSTACLES, settings.walls());
    return settings.floorplan().map(empty::withFloorplan).orElse(empty);
  }

  /** The question in one line. */
  static String line(int steps) {
    return "question: " + OBJECTIVE + " by " + DETECTION + " in " + steps + " steps";
  }

  /** Adds a comment to the XML of a scenario. */
  static String commented(String xml, String comment) {
    String safe = Place.printable(comment).replace("--", "- -");
    return xml.replaceFirst(
        "\n<root>", Matcher.quoteReplacement("\n<!-- " + safe + " -->\n<root>"));
  }
}
