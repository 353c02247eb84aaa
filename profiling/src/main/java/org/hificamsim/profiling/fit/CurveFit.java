package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.exception.MathIllegalStateException;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.fitting.leastsquares.MultivariateJacobianFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.util.Pair;

/**
 * Least squares of a curve by Levenberg and Marquardt, each parameter within its bounds, from the
 * best of several starts.
 */
final class CurveFit {
  private static final int MAX_STEPS = 400;

  /**
   * A positive parameter between two bounds, as a number without bounds for an optimiser that knows
   * none: {@code value = least (most / least)^(1 / (1 + exp(-t)))}.
   *
   * @param least above 0
   * @param most above {@code least}
   */
  record Bounded(double least, double most) {
    private static final double FARTHEST = 12;

    /** The parameter for a number of the optimiser's. */
    double value(double free) {
      return least * StrictMath.pow(most / least, share(free));
    }

    /** Its derivative there. */
    double slope(double free) {
      double share = share(free);
      return value(free) * StrictMath.log(most / least) * share * (1 - share);
    }

    /** The optimiser's number for a parameter; one at a bound is taken a little inside. */
    double free(double value) {
      double share = StrictMath.log(value / least) / StrictMath.log(most / least);
      double odds = share / (1 - share);
      return Math.max(-FARTHEST, Math.min(FARTHEST, StrictMath.log(odds)));
    }

    private static double share(double free) {
      return 1 / (1 + StrictMath.exp(-free));
    }
  }

  /** A curve with parameters. */
  interface Curve {
    /** Its height at x, and in {@code gradient} the derivative by each parameter. */
    double at(double x, double[] parameters, double[] gradient);
  }

  private final Curve curve;
  private final List<Bounded> bounds;
  private final double[] x;
  private final double[] y;

  /**
   * @param bounds of each parameter; null for one that may be any number
   */
  CurveFit(Curve curve, List<Bounded> bounds, double[] x, double[] y) {
    this.curve = curve;
    this.bounds = bounds;
    this.x = x.clone();
    this.y = y.clone();
  }

  /** The parameters with the least squared error that is found from the best of the starts. */
  double[] from(List<double[]> starts) {
    double[] start = starts.get(0);
    for (double[] other : starts) {
      start = error(other) < error(start) ? other : start;
    }
    double[] found = optimum(start);
    return error(found) < error(start) ? found : start;
  }

  private double[] optimum(double[] start) {
    try {
      return parameters(
          new LevenbergMarquardtOptimizer()
              .optimize(
                  new LeastSquaresBuilder()
                      .start(free(start))
                      .model((MultivariateJacobianFunction) this::values)
                      .target(y)
                      .lazyEvaluation(false)
                      .maxEvaluations(MAX_STEPS)
                      .maxIterations(MAX_STEPS)
                      .build())
              .getPoint()
              .toArray());
    } catch (MathIllegalStateException e) {
      return start; // no step gains anything, or none is left
    }
  }

  private Pair<RealVector, RealMatrix> values(RealVector point) {
    double[] free = point.toArray();
    double[] parameters = parameters(free);
    double[] heights = new double[x.length];
    double[][] slopes = new double[x.length][free.length];
    for (int i = 0; i < x.length; i++) {
      heights[i] = curve.at(x[i], parameters, slopes[i]);
      for (int k = 0; k < free.length; k++) {
        slopes[i][k] *= bounds.get(k) == null ? 1 : bounds.get(k).slope(free[k]);
      }
    }
    return new Pair<>(new ArrayRealVector(heights, false), new Array2DRowRealMatrix(slopes, false));
  }

  private double error(double[] parameters) {
    double[] gradient = new double[parameters.length];
    double sum = 0;
    for (int i = 0; i < x.length; i++) {
      double error = y[i] - curve.at(x[i], parameters, gradient);
      sum += error * error;
    }
    return sum;
  }

  private double[] parameters(double[] free) {
    double[] parameters = free.clone();
    Arrays.setAll(parameters, k -> bounds.get(k) == null ? free[k] : bounds.get(k).value(free[k]));
    return parameters;
  }

  private double[] free(double[] parameters) {
    double[] free = parameters.clone();
    Arrays.setAll(
        free, k -> bounds.get(k) == null ? parameters[k] : bounds.get(k).free(parameters[k]));
    return free;
  }
}
