package org.hificamsim.profiling.boxes;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.apache.commons.math3.exception.MathIllegalStateException;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.fitting.leastsquares.MultivariateJacobianFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.util.Pair;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.hifi.boxes.WidthEffect;
import org.hificamsim.profiling.fit.Bounded;

/**
 * Fits a {@link FoundCurve} by maximum likelihood: Levenberg and Marquardt's least squares of the
 * deviance residuals, whose squares sum up to twice the log loss. The signs of the slopes are
 * bounded, so that the curve is monotone: at any height a wider box is found as surely, and at any
 * width a higher one.
 *
 * <p>The frames of a person are nearly one observation. Each person counts as the root of the
 * number of their boxes, so that neither one who stands for a minute decides, nor one who is seen
 * for a second.
 */
final class FoundFit {
  private static final int MAX_STEPS = 400;
  private static final double LEAST_CHANCE = 1e-9;
  private static final int PARAMETERS = 6;

  /**
   * The weight of even odds, which keeps the intercept finite if everybody was found, or nobody.
   */
  private static final double PULL_TO_EVEN_ODDS = 0.01;

  /**
   * The bounds of all parameters except the intercept: height, hidden, floor, 1 - ceiling, width.
   */
  private static final List<Bounded> BOUNDS =
      List.of(
          new Bounded(1e-3, 20),
          new Bounded(1e-3, 60),
          new Bounded(1e-4, .5),
          new Bounded(1e-4, .5),
          new Bounded(1e-3, 20));

  private static final double[] START = {1, 3, .02, .02, 1};

  private final FoundForm form;
  private final List<PersonBox> boxes;
  private final double[] weights;
  private final double usualShape;

  /** The best of all points that the optimizer has tried, and its sum of squares. */
  private double[] best;

  private double leastSum = Double.POSITIVE_INFINITY;

  private FoundFit(FoundForm form, List<PersonBox> boxes) {
    this.form = form;
    this.boxes = boxes;
    this.weights = rootWeights(boxes);
    this.usualShape = StrictMath.exp(meanLogShape());
  }

  private double meanLogShape() {
    double sum = 0;
    double total = 0;
    for (int i = 0; i < weights.length; i++) {
      PersonBox box = boxes.get(i);
      sum += weights[i] * weights[i] * StrictMath.log(box.width() / box.height());
      total += weights[i] * weights[i];
    }
    return sum / total;
  }

  /** Returns the roots of the weights of boxes, the squares of which have the mean 1. */
  private static double[] rootWeights(List<PersonBox> boxes) {
    Map<String, Long> counts =
        boxes.stream()
            .map(PersonBox::person)
            .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
    double[] weights =
        boxes.stream().mapToDouble(box -> 1 / Math.sqrt(counts.get(box.person()))).toArray();
    double mean = Arrays.stream(weights).average().orElseThrow();
    return Arrays.stream(weights).map(weight -> Math.sqrt(weight / mean)).toArray();
  }

  /** Returns the curve of a form that fits some boxes best. */
  static FoundCurve fit(FoundForm form, List<PersonBox> boxes) {
    return new FoundFit(form, boxes).fit();
  }

  private FoundCurve fit() {
    double found = boxes.stream().mapToInt(PersonBox::found).average().orElseThrow();
    double[] start = new double[PARAMETERS];
    double share = Math.max(0.01, Math.min(0.99, found));
    start[0] = StrictMath.log(share / (1 - share));
    for (int i = 1; i < PARAMETERS; i++) {
      start[i] = BOUNDS.get(i - 1).free(START[i - 1]);
    }
    optimize(start);
    return curve(best);
  }

  private void optimize(double[] start) {
    try {
      new LevenbergMarquardtOptimizer()
          .optimize(
              new LeastSquaresBuilder()
                  .start(start)
                  .model((MultivariateJacobianFunction) this::residuals)
                  .target(new double[boxes.size() + 1])
                  .lazyEvaluation(false)
                  .maxEvaluations(MAX_STEPS)
                  .maxIterations(MAX_STEPS)
                  .build());
    } catch (MathIllegalStateException e) {
      // no step improves the best point any more, or the limit of steps is reached
    }
  }

  private FoundCurve curve(double[] point) {
    double width = form.hasWidth() ? BOUNDS.get(4).value(point[5]) : 0;
    return new FoundCurve(
        point[0],
        form.hasHeight() ? BOUNDS.get(0).value(point[1]) + width : 0,
        form.hasHidden() ? BOUNDS.get(1).value(point[2]) : 0,
        form.hasFloor() ? BOUNDS.get(2).value(point[3]) : 0,
        form.hasCeiling() ? 1 - BOUNDS.get(3).value(point[4]) : 1,
        form.hasWidth() ? new WidthEffect(width, usualShape) : WidthEffect.NONE);
  }

  private Pair<RealVector, RealMatrix> residuals(RealVector vector) {
    double[] point = vector.toArray();
    FoundCurve curve = curve(point);
    double[] residuals = new double[boxes.size() + 1];
    double[][] slopes = new double[boxes.size() + 1][PARAMETERS];
    double[] boundSlopes = new double[PARAMETERS];
    Arrays.setAll(boundSlopes, k -> k == 0 ? 1 : BOUNDS.get(k - 1).slope(point[k]));
    for (int i = 0; i < boxes.size(); i++) {
      residuals[i] = residual(boxes.get(i), curve, weights[i], slopes[i]);
      for (int k = 1; k < PARAMETERS; k++) {
        slopes[i][k] *= boundSlopes[k];
      }
    }
    residuals[boxes.size()] = PULL_TO_EVEN_ODDS * point[0];
    slopes[boxes.size()][0] = PULL_TO_EVEN_ODDS;
    double sum = Arrays.stream(residuals).map(residual -> residual * residual).sum();
    if (sum < leastSum) {
      leastSum = sum;
      best = point;
    }
    return new Pair<>(
        new ArrayRealVector(residuals, false), new Array2DRowRealMatrix(slopes, false));
  }

  /** Returns the deviance residual of a box, and sets its derivative by each parameter. */
  private double residual(PersonBox box, FoundCurve curve, double weight, double[] slopes) {
    double grown = StrictMath.log(box.height() / FoundCurve.USUAL_PIXELS);
    double widened = StrictMath.log(box.width() / (usualShape * FoundCurve.USUAL_PIXELS));
    double found = box.chance(curve);
    double span = curve.ceiling() - curve.floor();
    double logistic = (found - curve.floor()) / span;
    double outcome = Math.max(LEAST_CHANCE, box.found() == 1 ? found : 1 - found);
    double residual = Math.max(1e-8, Math.sqrt(-2 * StrictMath.log(outcome)));
    double byFound = (box.found() == 1 ? -1 : 1) * weight / (residual * outcome);
    double byOdds = byFound * span * logistic * (1 - logistic);
    slopes[0] = byOdds;
    slopes[1] = form.hasHeight() ? byOdds * grown : 0;
    slopes[2] = form.hasHidden() ? -byOdds * box.hidden() : 0;
    slopes[3] = form.hasFloor() ? byFound * (1 - logistic) : 0;
    slopes[4] = form.hasCeiling() ? -byFound * logistic : 0;
    slopes[5] = form.hasWidth() ? byOdds * widened : 0;
    return weight * residual;
  }
}
