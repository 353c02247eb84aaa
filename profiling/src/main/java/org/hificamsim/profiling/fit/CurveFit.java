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
 * Fits a curve by least squares (Levenberg and Marquardt) from the best of several starts. Each
 * parameter stays within its bounds.
 */
final class CurveFit {
  private static final int MAX_STEPS = 400;

  /** A curve with parameters. */
  interface Curve {
    /** Returns the value at x and sets {@code gradient} to the derivative by each parameter. */
    double value(double x, double[] parameters, double[] gradient);
  }

  private final Curve curve;
  private final List<Bounded> bounds;
  private final double[] x;
  private final double[] y;

  /**
   * @param bounds the bounds of each parameter; null for one without bounds
   */
  CurveFit(Curve curve, List<Bounded> bounds, double[] x, double[] y) {
    this.curve = curve;
    this.bounds = bounds;
    this.x = x.clone();
    this.y = y.clone();
  }

  /** Returns the parameters with the least squared error found from the best of the starts. */
  double[] fitFrom(List<double[]> starts) {
    double[] start = starts.get(0);
    for (double[] candidate : starts) {
      start = error(candidate) < error(start) ? candidate : start;
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
      return start; // no step improves the fit, or the limit of steps is reached
    }
  }

  private Pair<RealVector, RealMatrix> values(RealVector point) {
    double[] free = point.toArray();
    double[] parameters = parameters(free);
    double[] values = new double[x.length];
    double[][] slopes = new double[x.length][free.length];
    for (int i = 0; i < x.length; i++) {
      values[i] = curve.value(x[i], parameters, slopes[i]);
      for (int k = 0; k < free.length; k++) {
        slopes[i][k] *= bounds.get(k) == null ? 1 : bounds.get(k).slope(free[k]);
      }
    }
    return new Pair<>(new ArrayRealVector(values, false), new Array2DRowRealMatrix(slopes, false));
  }

  private double error(double[] parameters) {
    double[] gradient = new double[parameters.length];
    double sum = 0;
    for (int i = 0; i < x.length; i++) {
      double error = y[i] - curve.value(x[i], parameters, gradient);
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
