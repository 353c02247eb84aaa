package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Least squares of covariates' weights, with a g of one shape fitted to each try: one weight after
 * the other by Brent's method, until none of them gains anything.
 */
final class ShiftFitting {
  private static final double TOLERANCE = 1e-4; // in standard deviations of a covariate
  private static final double MAX_WEIGHT = 3; // for one of them: a factor of 20
  private static final double MAX_SHIFT = 20; // from the least to the greatest value
  private static final int MAX_TRIES = 60;
  private static final int MAX_ROUNDS = 6;
  private static final double GAIN = 1e-5;

  private final DetectorRegression shape;
  private final List<Measurement> photos;
  private final double[] pip;
  private final double[] confidences;

  /**
   * @param pip the share of each photo
   * @param confidences what one detector has measured of it
   */
  ShiftFitting(
      DetectorRegression shape, List<Measurement> photos, double[] pip, double[] confidences) {
    this.shape = shape;
    this.photos = photos;
    this.pip = pip;
    this.confidences = confidences;
  }

  /** The mean and spread of a covariate over all photos. */
  record Scale(Covariate covariate, double mean, double deviation, double limit) {
    static Scale of(Covariate covariate, List<Measurement> photos) {
      double[] values = values(covariate, photos);
      double mean = Arrays.stream(values).average().orElseThrow();
      double squares = Arrays.stream(values).map(x -> (x - mean) * (x - mean)).sum();
      double deviation = Math.sqrt(squares / values.length);
      double span =
          Arrays.stream(values).max().orElseThrow() - Arrays.stream(values).min().orElseThrow();
      return new Scale(
          covariate, mean, deviation, Math.min(MAX_WEIGHT, MAX_SHIFT * deviation / span));
    }

    Shift.Term term(double weight) {
      return new Shift.Term(covariate, weight / deviation, mean);
    }
  }

  static double[] values(Covariate covariate, List<Measurement> photos) {
    return photos.stream().mapToDouble(m -> m.covariates().get(covariate)).toArray();
  }

  /** The weights for some rows; the means are those of all photos. */
  Shift fit(List<Covariate> covariates, int[] rows) {
    List<Scale> scales = covariates.stream().map(one -> Scale.of(one, photos)).toList();
    double[] weights = new double[scales.size()];
    double error = error(scales, weights, rows);
    for (int round = 0; round < MAX_ROUNDS && !scales.isEmpty(); round++) {
      double before = error;
      for (int k = 0; k < weights.length; k++) {
        error = improve(scales, weights, k, rows);
      }
      if (weights.length == 1 || !(error < before * (1 - GAIN))) {
        break;
      }
    }
    return shift(scales, weights);
  }

  private double improve(List<Scale> scales, double[] weights, int k, int[] rows) {
    double limit = scales.get(k).limit();
    var best =
        new BrentOptimizer(TOLERANCE, TOLERANCE)
            .optimize(
                new MaxEval(MAX_TRIES),
                new UnivariateObjectiveFunction(
                    weight -> error(scales, with(weights, k, weight), rows)),
                GoalType.MINIMIZE,
                new SearchInterval(-limit, limit, weights[k]));
    weights[k] = best.getPoint();
    return best.getValue();
  }

  private static double[] with(double[] weights, int k, double weight) {
    double[] changed = weights.clone();
    changed[k] = weight;
    return changed;
  }

  private double error(List<Scale> scales, double[] weights, int[] rows) {
    double[] x = Groups.at(rows, shift(scales, weights).applied(pip, photos));
    double[] y = Groups.at(rows, confidences);
    DetectorModel g = shape.fit(x, y);
    return Scores.of(y, Arrays.stream(x).map(g::confidence).toArray()).sse();
  }

  private static Shift shift(List<Scale> scales, double[] weights) {
    return new Shift(
        IntStream.range(0, weights.length).mapToObj(k -> scales.get(k).term(weights[k])).toList());
  }
}
