package org.hificamsim.profiling.check;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.profiling.check.ErrorSummary.Quantity;

/**
 * A sighting and what was predicted of it.
 *
 * @param distance from camera to target over the ground, metres
 * @param footError from where the calibration has the target's foot to where the box stands, pixels
 * @param predicted by each rung
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
        camera.project(sighting.foot()).distance(sighting.stand()),
        predicted);
  }

  /** Whether the camera sees the place at all, and something is predicted. */
  boolean possible() {
    return predicted.values().stream().allMatch(size -> size.area() > 0) && footError >= 0;
  }

  Size predicted(SizeModel rung) {
    return predicted.get(rung);
  }

  /** The error of a prediction as a share of what was measured; above 0 where it is too large. */
  double error(SizeModel rung, Quantity quantity) {
    double measured = quantity.of(sighting.size());
    return (quantity.of(predicted(rung)) - measured) / measured;
  }
}
