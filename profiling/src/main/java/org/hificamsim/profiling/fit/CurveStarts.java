package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/** Where fits of curves start, and how far they may go. */
final class CurveStarts {
  private static final double[] PERCENTS = {5, 20, 35, 50, 65, 80, 95};
  private static final double SMALLEST = 1e-9;

  private CurveStarts() {}

  /** Shares of the image at which something may happen: percentiles of those that are above 0. */
  static double[] shares(double[] pip) {
    double[] positive = Arrays.stream(pip).filter(p -> p > SMALLEST).toArray();
    if (positive.length == 0) {
      return new double[] {0.5};
    }
    Percentile percentile = new Percentile();
    percentile.setData(positive);
    return Arrays.stream(PERCENTS).map(percentile::evaluate).toArray();
  }

  /** A share may lie a hundred times beyond what was seen. */
  static Bounded bounds(double[] pip) {
    double[] shares = shares(pip);
    return new Bounded(shares[0] / 100, 100 * Math.max(shares[shares.length - 1], shares[0]));
  }

  /** The best floor and rise for a curve from 0 to 1; the rise is kept above 0. */
  static double[] floorAndRise(double[] pip, double[] y, DoubleUnaryOperator unit, Bounded rises) {
    SimpleRegression line = new SimpleRegression();
    for (int i = 0; i < y.length; i++) {
      line.addData(unit.applyAsDouble(pip[i]), y[i]);
    }
    double rise = line.getSlope();
    boolean usable = rise > rises.least() && rise < rises.most();
    return usable
        ? new double[] {line.getIntercept(), rise}
        : new double[] {Arrays.stream(y).average().orElse(0), 2 * rises.least()};
  }
}
