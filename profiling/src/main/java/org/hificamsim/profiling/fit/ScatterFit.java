package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.hifi.Residuals;

/**
 * The scatter of measured confidences about a g that has not seen them, and the quality of the
 * resulting chances of a detection.
 *
 * @param name the kind: {@code constant} or {@code growing}
 * @param residuals the residuals of all photos
 * @param calibration the chances of the detection rule chance with its default options, for photos
 *     that neither g nor the residuals have seen; both kinds use the same thresholds
 */
public record ScatterFit(String name, Residuals residuals, Reliability calibration) {
  private static final double LEAST_RATIO = 1e-2;
  private static final double MOST_RATIO = 1e4;
  private static final int RATIOS = 60;
  private static final double TOLERANCE = 1e-9;
  private static final int MAX_STEPS = 200;

  /** Fits residuals to errors, and to gains: how far g lies above its value at a PIP of 0. */
  private interface Method {
    Residuals fit(double[] gains, double[] errors);
  }

  /**
   * Fits both kinds: a constant standard deviation, the root mean squared error, and one that grows
   * with the confidence, by maximum likelihood.
   */
  static List<ScatterFit> constantAndGrowing(ShapeFit g, double[] y, Groups groups) {
    double[] gains =
        groups.forEachRow(
            (group, row) -> Math.max(0, g.predicted()[row] - g.fits().get(group).confidence(0)));
    double[] errors = MathArrays.ebeSubtract(y, g.predicted());
    Map<String, Method> kinds = new LinkedHashMap<>();
    kinds.put("constant", (unusedGains, fitErrors) -> Residuals.of(rootMeanSquare(fitErrors)));
    kinds.put("growing", ScatterFit::mostLikely);
    List<ScatterFit> fits = new ArrayList<>();
    kinds.forEach(
        (name, method) -> {
          List<Residuals> unseen =
              IntStream.range(0, groups.count())
                  .mapToObj(groups::others)
                  .map(rows -> method.fit(Groups.select(rows, gains), Groups.select(rows, errors)))
                  .toList();
          fits.add(
              new ScatterFit(name, method.fit(gains, errors), calibration(g, y, groups, unseen)));
        });
    return fits;
  }

  private static Reliability calibration(
      ShapeFit g, double[] y, Groups groups, List<Residuals> unseen) {
    List<Scatter> scatters =
        IntStream.range(0, groups.count())
            .mapToObj(group -> unseen.get(group).about(g.fits().get(group)))
            .toList();
    double[] thresholds =
        scatters.stream().mapToDouble(scatter -> scatter.threshold(Chance.DEFAULT_ALPHA)).toArray();
    return new Reliability(
        groups.forEachRow(
            (group, row) -> scatters.get(group).chance(g.predicted()[row], thresholds[group])),
        groups.forEachRow((group, row) -> y[row] >= thresholds[group] ? 1 : 0));
  }

  /**
   * Fits growing residuals. For a given ratio of growth to least deviation, the most likely least
   * deviation is the root mean square of the errors, each divided by its relative deviation. The
   * ratio is searched on a grid, and then between the neighbours of the best one.
   */
  private static Residuals mostLikely(double[] gains, double[] errors) {
    double step = StrictMath.log(MOST_RATIO / LEAST_RATIO) / RATIOS;
    DoubleUnaryOperator loss = logRatio -> loss(StrictMath.exp(logRatio), gains, errors);
    double bestLogRatio =
        IntStream.rangeClosed(0, RATIOS)
            .mapToObj(i -> StrictMath.log(LEAST_RATIO) + i * step)
            .min(Comparator.comparingDouble(loss::applyAsDouble))
            .orElseThrow();
    double refinedLogRatio =
        new BrentOptimizer(TOLERANCE, TOLERANCE)
            .optimize(
                new UnivariateObjectiveFunction(loss::applyAsDouble),
                GoalType.MINIMIZE,
                new SearchInterval(bestLogRatio - step, bestLogRatio + step, bestLogRatio),
                new MaxEval(MAX_STEPS))
            .getPoint();
    double ratio =
        loss.applyAsDouble(refinedLogRatio) < loss(0, gains, errors)
            ? StrictMath.exp(refinedLogRatio)
            : 0;
    double least = rootMeanSquare(scaledErrors(ratio, gains, errors));
    return new Residuals(rootMeanSquare(errors), least, ratio * least);
  }

  /** Returns the mean negative log-likelihood of a photo, up to a constant. */
  private static double loss(double ratio, double[] gains, double[] errors) {
    double logs = 0;
    for (double gain : gains) {
      logs += StrictMath.log(1 + ratio * gain);
    }
    return logs / gains.length + StrictMath.log(rootMeanSquare(scaledErrors(ratio, gains, errors)));
  }

  private static double[] scaledErrors(double ratio, double[] gains, double[] errors) {
    return IntStream.range(0, errors.length)
        .mapToDouble(i -> errors[i] / (1 + ratio * gains[i]))
        .toArray();
  }

  private static double rootMeanSquare(double[] errors) {
    double sum = 0;
    for (double error : errors) {
      sum += error * error;
    }
    return Math.sqrt(sum / errors.length);
  }
}
