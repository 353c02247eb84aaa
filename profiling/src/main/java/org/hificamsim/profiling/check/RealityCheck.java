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
   * Compares sightings with predictions.
   *
   * @param body the assumed size of targets, in metres
   * @throws InputException when there are no sightings or they do not fit the calibration
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
    check.requireFittingPositions();
    return check;
  }

  /** Rejects positions in another unit or of another camera, whose errors would be meaningless. */
  private void requireFittingPositions() {
    double height =
        median(comparisons.stream().mapToDouble(box -> box.sighting().box().height()).toArray());
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

  private static double bandWidth(List<BoxComparison> comparisons) {
    double leastWidth =
        comparisons.stream().mapToDouble(BoxComparison::distance).max().orElseThrow() / MAX_BANDS;
    double powerOfTen = Math.pow(10, Math.floor(Math.log10(leastWidth)));
    for (int factor : new int[] {1, 2, 5}) {
      if (factor * powerOfTen >= leastWidth) {
        return factor * powerOfTen;
      }
    }
    return 10 * powerOfTen;
  }

  List<BoxComparison> comparisons() {
    return comparisons;
  }

  /** Returns the share of the picture that a box fills. */
  double pip(Size box) {
    return box.area() / camera.picture().area();
  }

  /** Returns the number of boxes that were compared. */
  public int boxes() {
    return comparisons.size();
  }

  /**
   * Returns the median distance between the projected foot of a target and that of its box, in
   * pixels.
   */
  public double footError() {
    return median(comparisons.stream().mapToDouble(BoxComparison::footError).toArray());
  }

  private static double median(double[] values) {
    return StatUtils.percentile(values, 50);
  }

  /** Summarises the errors of all boxes, for each rung and quantity. */
  public List<ErrorSummary> overall() {
    double most = comparisons.stream().mapToDouble(BoxComparison::distance).max().orElseThrow();
    return summaries(0, most, comparisons);
  }

  /**
   * Summarises the errors in bands of distance, the nearest first; bands without boxes are left
   * out.
   */
  public List<ErrorSummary> byDistance() {
    List<ErrorSummary> summaries = new ArrayList<>();
    for (int band = 0; band <= MAX_BANDS; band++) {
      double from = band * bandWidth;
      double to = from + bandWidth;
      List<BoxComparison> within =
          comparisons.stream()
              .filter(box -> box.distance() >= from && box.distance() < to)
              .toList();
      if (!within.isEmpty()) {
        summaries.addAll(summaries(from, to, within));
      }
    }
    return summaries;
  }

  private static List<ErrorSummary> summaries(double from, double to, List<BoxComparison> within) {
    List<ErrorSummary> summaries = new ArrayList<>();
    for (BoxQuantity quantity : BoxQuantity.values()) {
      for (SizeModel rung : SizeModel.values()) {
        summaries.add(ErrorSummary.of(rung, quantity, from, to, within));
      }
    }
    return summaries;
  }
}
