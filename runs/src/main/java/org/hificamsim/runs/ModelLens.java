package org.hificamsim.runs;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;

/**
 * The lens through which a detection model looks in a scenario: what the scenario leaves open, the
 * model's optics decide (Eqs 3.1 and 3.2).
 */
public record ModelLens(Optics optics, Scenario scenario) {
  /** The lens of a model; empty for models that have none. */
  public static Optional<ModelLens> of(Detection detection, Scenario scenario) {
    return detection.model() instanceof OpticalDetection model
        ? Optional.of(new ModelLens(model.optics(), scenario))
        : Optional.empty();
  }

  /**
   * The focal length of each radius of the zoom list, metres, from the narrowest; none where each
   * camera has its own range.
   */
  public List<Double> focalLengths() {
    return scenario.inCoverageDialect()
        ? World.zoomLevels(scenario).stream()
            .filter(zoom -> !zoom.hasLens())
            .map(optics::focalLength)
            .distinct()
            .toList()
        : List.of();
  }

  /**
   * The height of all cameras over the target plane, metres: the scenario's, or the one at which
   * the narrowest radius has the longest focal length. Empty where each camera would have its own.
   */
  public OptionalDouble mountHeight() {
    return scenario.mountHeight().isPresent() || !scenario.inCoverageDialect()
        ? scenario.mountHeight()
        : OptionalDouble.of(
            optics.mountHeight(scenario.zooms().get(0), optics.longestFocalLength()));
  }

  /** The angle of view that the focal length gives at a zoom level, degrees (Eq 3.1). */
  public double angleOfView(ZoomLevel zoom) {
    return Math.toDegrees(optics.angleOfView(optics.focalLength(zoom)));
  }
}
