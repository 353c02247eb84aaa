package org.hificamsim.runs.hints;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/**
 * Warns of scenarios and detections that do not suit each other: a model that sees hardly any
 * target, that was fitted on other sizes or distances, or whose lens contradicts the cameras.
 *
 * <pre>{@code
 * DetectionHints.of(scenario, detection, catalogue).forEach(System.err::println);
 * }</pre>
 */
public final class DetectionHints {
  private DetectionHints() {}

  /**
   * Returns the warnings, one line each; an empty list if there are none. The targets are moved for
   * up to a hundred steps to find out how near they come to a camera.
   */
  public static List<String> of(Scenario scenario, Detection detection, Catalogue catalogue) {
    return Stream.of(
            ReachHint.of(scenario, detection, catalogue),
            LensHint.of(scenario, detection),
            FittedRangeHint.of(scenario, detection),
            overriddenThreshold(scenario, detection),
            flatModel(scenario, detection),
            BlindViewHint.of(scenario, detection, catalogue))
        .flatMap(Optional::stream)
        .toList();
  }

  /** Warns if the scenario's threshold replaces that of a model that the user chose. */
  private static Optional<String> overriddenThreshold(Scenario scenario, Detection detection) {
    String model = detection.model().name();
    double modelsThreshold = detection.model().defaultThreshold();
    boolean isReplaced =
        detection.certain()
            && detection.name().equals(model)
            && scenario.find(Scenario.DETECTION).isEmpty()
            && scenario.threshold().orElse(modelsThreshold) == detection.threshold()
            && modelsThreshold != detection.threshold();
    return isReplaced
        ? Optional.of(
            Texts.format(
                "its threshold %s is used for '%s', whose own is %s; expected detection %s@%s"
                    + " where that one is meant",
                detection.threshold(), model, modelsThreshold, model, modelsThreshold))
        : Optional.empty();
  }

  /** Warns if a model of CamSim, which ignores heights, is used for cameras with heights. */
  private static Optional<String> flatModel(Scenario scenario, Detection detection) {
    return scenario.hasHeights() && detection.model().flat()
        ? Optional.of(
            Texts.format(
                "'%s' is a rule of CamSim, whose world is flat: it gets distances over the"
                    + " ground, not those from where cameras hang",
                detection.name()))
        : Optional.empty();
  }
}
