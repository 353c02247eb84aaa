package org.hificamsim.hifi.boxes;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.optics.Optics;

/**
 * A detector that draws boxes around people. Its value is the probability that it finds a target,
 * by the target's height in pixels and by the share of it that obstacles and nearer targets hide.
 *
 * @param name the name on the command line and in result files
 * @param curve the probability by height and hidden share
 * @param optics determine the angle of view if the scenario names no lens
 * @param falseAlarms the mean number of boxes in a frame that show nobody, 0 or more
 * @param fitted the boxes that the numbers were fitted on, if known
 * @param provenance where the numbers come from
 */
public record BoxDetection(
    String name,
    FoundCurve curve,
    Optics optics,
    double falseAlarms,
    Optional<FittedBoxes> fitted,
    Provenance provenance)
    implements FittedDetection {
  @Override
  public BoxDetection named(String newName) {
    return new BoxDetection(newName, curve, optics, falseAlarms, fitted, provenance);
  }

  @Override
  public String equation() {
    return "P(found) = " + curve.equation();
  }

  /** Returns the height of a target in the picture, in pixels; infinite at distance 0. */
  public double pixels(double height, double distance, ZoomLevel zoom) {
    return height * optics.pixelsPerMetre(zoom, distance);
  }

  @Override
  public double confidence(double height, double distance, double offAxis, ZoomLevel zoom) {
    return curve.found(pixels(height, distance, zoom), 0);
  }

  @Override
  public double confidence(
      double height, double distance, double offAxis, ZoomLevel zoom, double hiddenShare) {
    return curve.found(pixels(height, distance, zoom), hiddenShare);
  }

  @Override
  public boolean byHeight() {
    return true;
  }

  @Override
  public boolean dependsOnHiddenShare() {
    return true;
  }

  @Override
  public DetectionRule defaultRule() {
    return DetectionRule.parse("probability");
  }

  @Override
  public OptionalDouble phantoms() {
    return OptionalDouble.of(falseAlarms);
  }
}
