package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;

/**
 * A shape of g and how to fit it. To add a shape, add a line to {@link #ALL}. Curves with
 * parameters are fitted by least squares from several starts ({@link CurveFit}).
 *
 * @param name the short name, the type in model files
 * @param method fits confidences to PIP; deterministic
 */
public record DetectorShape(String name, BiFunction<double[], double[], DetectorModel> method) {
  /** Every shape, the one with the fewest parameters first. */
  public static final List<DetectorShape> ALL =
      List.of(
          new DetectorShape("line", (pip, y) -> LineFit.of(pip, y).line()), // Eqs 5.2 to 5.4
          new DetectorShape("logistic", DetectorShape::logistic),
          new DetectorShape("saturating-exponential", DetectorShape::saturating),
          new DetectorShape("hill", DetectorShape::hill),
          new DetectorShape("isotonic", IsotonicFit::fit));

  private static final Bounded RISES = new Bounded(1e-6, 1e4);
  private static final Bounded EXPONENTS = new Bounded(0.1, 20);
  private static final double[] LOGISTIC_STARTS = {0.3, 1, 3};
  private static final double[] HILL_STARTS = {0.7, 1, 2, 4};
  private static final double[] PERCENTS = {5, 20, 35, 50, 65, 80, 95};
  private static final double SMALLEST = 1e-9;

  /** Returns the names of all shapes. */
  public static List<String> names() {
    return ALL.stream().map(DetectorShape::name).toList();
  }

  /**
   * Returns the shape of a name.
   *
   * @throws InputException when there is no such shape
   */
  public static DetectorShape of(String name) {
    return ALL.stream()
        .filter(shape -> shape.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "g '%s' is unknown, expected one of %s", name, String.join(", ", names())));
  }

  /**
   * Fits the shape.
   *
   * @param pip the PIP of each row, [0, 1]
   * @param confidence the measured confidence of each row
   * @throws InputException when there are fewer than three rows
   */
  DetectorModel fit(double[] pip, double[] confidence) {
    return method.apply(pip, confidence);
  }

  /** Fits the logistic curve in log PIP with parameters half and exponent. */
  private static LogisticCurve logistic(double[] pip, double[] confidence) {
    List<double[]> starts = new ArrayList<>();
    for (double half : shares(pip)) {
      for (double exponent : LOGISTIC_STARTS) {
        starts.add(new double[] {half, exponent});
        starts.add(new double[] {100 * half, exponent});
      }
    }
    Bounded halves = new Bounded(bounds(pip).least(), 1e4 * bounds(pip).most());
    double[] found =
        new CurveFit(
                (p, parameters, gradient) ->
                    reachedShare(p, parameters[0], parameters[1], 1, gradient, 0),
                List.of(halves, EXPONENTS),
                pip,
                confidence)
            .fitFrom(starts);
    return new LogisticCurve(found[0], found[1]);
  }

  /** Fits {@code floor + rise (1 - exp(-PIP / scale))}, rise and scale above 0. */
  private static SaturatingExponential saturating(double[] pip, double[] confidence) {
    List<double[]> starts = new ArrayList<>();
    for (double scale : shares(pip)) {
      double[] linear = floorAndRise(pip, confidence, p -> -StrictMath.expm1(-p / scale));
      starts.add(new double[] {linear[0], linear[1], scale});
    }
    double[] found =
        new CurveFit(
                DetectorShape::saturatingValue,
                Arrays.asList(null, RISES, bounds(pip)),
                pip,
                confidence)
            .fitFrom(starts);
    return new SaturatingExponential(found[0], found[1], found[2]);
  }

  private static double saturatingValue(double pip, double[] parameters, double[] gradient) {
    double remainingShare = StrictMath.exp(-pip / parameters[2]);
    gradient[0] = 1;
    gradient[1] = 1 - remainingShare;
    gradient[2] = -parameters[1] * remainingShare * pip / (parameters[2] * parameters[2]);
    return parameters[0] + parameters[1] * (1 - remainingShare);
  }

  /** Fits the Hill curve: floor, rise, half and exponent, all above 0 except the floor. */
  private static HillCurve hill(double[] pip, double[] confidence) {
    List<double[]> starts = new ArrayList<>();
    for (double half : shares(pip)) {
      for (double exponent : HILL_STARTS) {
        double[] linear = floorAndRise(pip, confidence, p -> reachedShare(p, half, exponent));
        starts.add(new double[] {linear[0], linear[1], half, exponent});
      }
    }
    List<Bounded> bounds = Arrays.asList(null, RISES, bounds(pip), EXPONENTS);
    double[] found =
        new CurveFit(DetectorShape::hillValue, bounds, pip, confidence).fitFrom(starts);
    return new HillCurve(found[0], found[1], found[2], found[3]);
  }

  private static double hillValue(double pip, double[] parameters, double[] gradient) {
    double reachedShare =
        reachedShare(pip, parameters[2], parameters[3], parameters[1], gradient, 2);
    gradient[0] = 1;
    gradient[1] = reachedShare;
    return parameters[0] + parameters[1] * reachedShare;
  }

  /**
   * Returns the share of the rise reached at a PIP, and sets the derivatives by half and exponent
   * in {@code gradient} at {@code first} and after it.
   */
  private static double reachedShare(
      double pip, double half, double exponent, double rise, double[] gradient, int first) {
    double reachedShare = reachedShare(pip, half, exponent);
    double steepness = rise * reachedShare * (1 - reachedShare);
    gradient[first] = -steepness * exponent / half;
    gradient[first + 1] = pip > 0 ? steepness * StrictMath.log(pip / half) : 0;
    return reachedShare;
  }

  private static double reachedShare(double pip, double half, double exponent) {
    return 1 / (1 + StrictMath.pow(half / pip, exponent));
  }

  /** Returns starts for parameters that are PIPs: percentiles of the PIPs above 0. */
  private static double[] shares(double[] pip) {
    double[] positive = Arrays.stream(pip).filter(p -> p > SMALLEST).toArray();
    if (positive.length == 0) {
      return new double[] {0.5};
    }
    Percentile percentile = new Percentile();
    percentile.setData(positive);
    return Arrays.stream(PERCENTS).map(percentile::evaluate).toArray();
  }

  /** Returns the bounds of parameters that are PIPs, a hundred times beyond the data. */
  private static Bounded bounds(double[] pip) {
    double[] shares = shares(pip);
    return new Bounded(shares[0] / 100, 100 * Math.max(shares[shares.length - 1], shares[0]));
  }

  /** Fits the floor and rise of a curve that runs from 0 to 1; the rise stays above 0. */
  private static double[] floorAndRise(double[] pip, double[] y, DoubleUnaryOperator unitCurve) {
    SimpleRegression line = new SimpleRegression();
    for (int i = 0; i < y.length; i++) {
      line.addData(unitCurve.applyAsDouble(pip[i]), y[i]);
    }
    double rise = line.getSlope();
    return rise > RISES.least() && rise < RISES.most()
        ? new double[] {line.getIntercept(), rise}
        : new double[] {Arrays.stream(y).average().orElse(0), 2 * RISES.least()};
  }
}
