package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A g on measured PIP with some covariates, and how it does on groups that it has not seen.
 *
 * @param shifts what the covariates do
 * @param g with them
 */
public record ShiftedFit(Shifts shifts, ShapeFit g) {
  /**
   * Fits weights and g, to all rows and without each group.
   *
   * @param alone the same shape without covariates
   */
  static ShiftedFit of(
      ShapeFit alone,
      List<Covariate> covariates,
      List<Measurement> photos,
      double[] confidences,
      Groups groups) {
    DetectorRegression shape = DetectorShapes.of(alone.shape());
    double[] pip = photos.stream().mapToDouble(Measurement::pip).toArray();
    ShiftFitting fitting = new ShiftFitting(shape, photos, pip, confidences);
    Shift shift = fitting.fit(covariates, IntStream.range(0, pip.length).toArray());
    List<Shift> unseen =
        IntStream.range(0, groups.count())
            .mapToObj(group -> fitting.fit(covariates, groups.others(group)))
            .toList();
    double[][] unseenX =
        unseen.stream().map(one -> one.applied(pip, photos)).toArray(double[][]::new);
    double[] x = shift.applied(pip, photos);
    ShapeFit g = ShapeFit.of(shape, x, unseenX, confidences, groups);
    return new ShiftedFit(new Shifts(shift, unseen, g.unseen().r2(), alone.unseen().r2()), g);
  }

  /** Without covariates. */
  static ShiftedFit plain(Groups groups, ShapeFit g) {
    return new ShiftedFit(Shifts.none(groups), g);
  }

  /** Whether it is better than another one by more than a standard error. */
  boolean helpsBeside(ShiftedFit other) {
    return OneStandardError.simplest(List.of(other.g.groupErrors(), g.groupErrors())) == 1;
  }
}
