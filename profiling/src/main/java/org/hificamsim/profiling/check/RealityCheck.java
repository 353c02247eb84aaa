package org.hificamsim.profiling.check;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.MotSightings.Sighting;

/** Compares sightings with predictions, and summarises the errors, overall and by distance. */
public final class RealityCheck {
  private static final double MAX_BANDS = 8;

  private final List<BoxComparison> comparisons;
  private final Calibration camera;
  private final double bandWidth;

  private RealityCheck(List<BoxComparison> comparisons, Calibration camera) {
    this.comparisons = comparisons;
    this.camera = camera;
    this.bandWidth = bandWidth(comparisons);
  }

  /**
   * Compares.
   *
   * @param body what targets are assumed to be like, metres
   * @throws InputException when the calibration is of another place than the sightings, or there
   *     are none
   */
  public static RealityCheck of(List<Sighting> sightings, Calibration camera, Size body) {
    List<BoxComparison> possible =
        sightings.stream()
            .map(sighting -> BoxComparison.of(sighting, camera, body))
            .filter(BoxComparison::isPossible)
            .toList();
    if (possible.isEmpty()) {
      throw InputException.of(
          "none of %s boxes is where the calibrated camera sees, expected positions and calibration"
              + " of one place; maybe %s or %s",
          sightings.size(), setting("unit"), setting("calibration_unit"));
    }
    RealityCheck check = new RealityCheck(possible, camera);
    check.requireOnePlace();
    return check;
  }

  /** Positions in another unit or of another camera would make errors that say nothing. */
  private void requireOnePlace() {
    double height =
        median(comparisons.stream().mapToDouble(one -> one.sighting().box().height()).toArray());
    if (footError() > height) {
      throw InputException.of(
          "half of the boxes stand %s pixels or more from where the calibration has"
              + " them, expected less than their height of %s; maybe %s or %s",
          Math.round(footError()),
          Math.round(height),
          setting("unit"),
          setting("calibration_unit"));
    }
  }

  private static double bandWidth(List<BoxComparison> all) {
    double least =
        all.stream().mapToDouble(BoxComparison::distance).max().orElseThrow() / MAX_BANDS;
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    for (int factor : new int[] {1, 2, 5}) {
      if (factor * power >= least) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  List<BoxComparison> comparisons() {
    return comparisons;
  }

  /** A box's share of the picture. */
  double pip(Size box) {
    return box.area() / camera.picture().area();
  }

  /** How many boxes were compared. */
  public int boxes() {
    return comparisons.size();
  }

  /** From where the calibration has feet to where boxes stand, the median, pixels. */
  public double footError() {
    return median(comparisons.stream().mapToDouble(BoxComparison::footError).toArray());
  }

  private static double median(double[] values) {
    return StatUtils.percentile(values, 50);
  }

  /** The errors of all boxes, a summary for each rung and quantity. */
  public List<ErrorSummary> overall() {
    double most = comparisons.stream().mapToDouble(BoxComparison::distance).max().orElseThrow();
    return summaries(0, most, comparisons);
  }

  /** The same in bands of distance, the nearest first; those without a box are left out. */
  public List<ErrorSummary> byDistance() {
    List<ErrorSummary> all = new ArrayList<>();
    for (int band = 0; band <= MAX_BANDS; band++) {
      double from = band * bandWidth;
      double to = from + bandWidth;
      List<BoxComparison> within =
          comparisons.stream().filter(o -> o.distance() >= from && o.distance() < to).toList();
      if (!within.isEmpty()) {
        all.addAll(summaries(from, to, within));
      }
    }
    return all;
  }

  private static List<ErrorSummary> summaries(double from, double to, List<BoxComparison> within) {
    List<ErrorSummary> all = new ArrayList<>();
    for (BoxQuantity quantity : BoxQuantity.values()) {
      for (SizeModel rung : SizeModel.values()) {
        all.add(ErrorSummary.of(rung, quantity, from, to, within));
      }
    }
    return all;
  }
}
