package org.hificamsim.profiling.check;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.MotSightings.Sighting;

/**
 * A sighting with the predictions of its size.
 *
 * @param distance the distance from camera to target over the ground, in metres
 * @param footError the distance between the projected foot of the target and that of its box,
 *     pixels
 * @param predicted the size that each rung predicts
 */
record BoxComparison(
    Sighting sighting, double distance, double footError, Map<SizeModel, Size> predicted) {
  static BoxComparison of(Sighting sighting, Calibration camera, Size body) {
    Map<SizeModel, Size> predicted = new EnumMap<>(SizeModel.class);
    for (SizeModel rung : SizeModel.values()) {
      predicted.put(rung, rung.size(camera, sighting.foot(), body));
    }
    return new BoxComparison(
        sighting,
        SizeModel.distance(camera, sighting.foot()),
        camera.project(sighting.foot()).distance(sighting.footPixel()),
        predicted);
  }

  /** Whether the camera sees the position and every rung predicts a size. */
  boolean isPossible() {
    return predicted.values().stream().allMatch(size -> size.area() > 0) && footError >= 0;
  }

  /** The error of a prediction as a share of the measured size; above 0 if it is too large. */
  double error(SizeModel rung, BoxQuantity quantity) {
    double measured = quantity.of(sighting.size());
    return (quantity.of(predicted.get(rung)) - measured) / measured;
  }
}
