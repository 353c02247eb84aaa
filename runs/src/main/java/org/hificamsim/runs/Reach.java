package org.hificamsim.runs;

import java.util.List;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.OnAxis;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;

/**
 * The distance to which a camera detects a target on its optical axis at one zoom level.
 *
 * @param radius the radius of the field of view, in metres
 * @param detected the largest distance at which the target is detected, in metres; 0 if there is
 *     none
 */
public record Reach(double radius, double detected) {
  private static final int MAX_LISTED = 10;

  /** The different reaches of the zoom levels of a scenario's cameras for its largest target. */
  public static List<Reach> of(Scenario scenario, Detection detection) {
    double size = largestTarget(scenario);
    return World.zoomLevels(scenario).stream()
        .map(zoom -> new Reach(zoom.radius(), detected(detection, size, zoom)))
        .distinct()
        .toList();
  }

  /** The largest distance at which a target is detected at any zoom level, in metres. */
  public static double farthest(Scenario scenario, Detection detection) {
    return of(scenario, detection).stream().mapToDouble(Reach::detected).max().orElse(0);
  }

  /**
   * Describes the reach at each zoom level; by chance, the distance to which a target is detected
   * half of the time.
   */
  public static String describe(Scenario scenario, Detection detection) {
    List<String> levels =
        of(scenario, detection).stream()
            .map(reach -> ShortNumber.of(reach.detected) + " of " + ShortNumber.of(reach.radius))
            .toList();
    String size = ShortNumber.of(largestTarget(scenario));
    return listed(levels) + " m (a target of " + size + " m)";
  }

  /** Joins texts by commas: the first ten, and dots for the others. */
  public static String listed(List<String> texts) {
    return texts.size() <= MAX_LISTED
        ? String.join(", ", texts)
        : String.join(", ", texts.subList(0, MAX_LISTED)) + ", ...";
  }

  /** The edge of the largest target that a scenario has at any time, in metres. */
  public static double largestTarget(Scenario scenario) {
    return scenario
        .everyTarget()
        .mapToDouble(TargetSpec::size)
        .max()
        .orElse(TargetSpec.DEFAULT_SIZE);
  }

  private static double detected(Detection detection, double size, ZoomLevel zoom) {
    DetectionModel model = detection.model();
    DetectedDistances distances =
        model.dependsOnBearing()
            ? DetectedDistances.of(new OnAxis(model), size, zoom, detection.threshold())
            : detection.distances(size, zoom); // a simulation uses the same cached object
    int last = distances.intervals() - 1;
    return last < 0 ? 0 : Math.sqrt(distances.to(last));
  }
}
