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
 * How measured confidences scatter about a g that has not seen them, and what the chances that
 * follow from it are worth.
 *
 * @param name of the kind: {@code constant} or {@code growing}
 * @param residuals of all photos
 * @param calibration of the chances of {@code --detect chance} with its default options, for photos
 *     that neither g nor the residuals have seen; both kinds are asked about the same thresholds
 */
public record ScatterFit(String name, Residuals residuals, Reliability calibration) {
  private static final double LEAST_RATIO = 1e-2;
  private static final double MOST_RATIO = 1e4;
  private static final int RATIOS = 60;
  private static final double TOLERANCE = 1e-9;
  private static final int MAX_STEPS = 200;

  /** Fits residuals to what g gains over its value for an empty image, and to the errors. */
  private interface Method {
    Residuals fit(double[] gained, double[] errors);
  }

  /**
   * Both kinds: one standard deviation, the root mean squared error; and one that grows with the
   * confidence, by maximum likelihood.
   */
  static List<ScatterFit> both(ShapeFit g, double[] y, Groups groups) {
    double[] gained =
        groups.each(
            (group, row) -> Math.max(0, g.predicted()[row] - g.fits().get(group).confidence(0)));
    double[] errors = MathArrays.ebeSubtract(y, g.predicted());
    Map<String, Method> kinds = new LinkedHashMap<>();
    kinds.put("constant", (any, e) -> Residuals.of(rms(e)));
    kinds.put("growing", ScatterFit::mostLikely);
    List<ScatterFit> both = new ArrayList<>();
    kinds.forEach(
        (name, method) -> {
          List<Residuals> unseen =
              IntStream.range(0, groups.count())
                  .mapToObj(groups::others)
                  .map(rows -> method.fit(Groups.at(rows, gained), Groups.at(rows, errors)))
                  .toList();
          both.add(
              new ScatterFit(name, method.fit(gained, errors), calibration(g, y, groups, unseen)));
        });
    return both;
  }

  private static Reliability calibration(
      ShapeFit g, double[] y, Groups groups, List<Residuals> unseen) {
    List<Scatter> scatters =
        IntStream.range(0, groups.count())
            .mapToObj(group -> unseen.get(group).about(g.fits().get(group)))
            .toList();
    double[] thresholds =
        scatters.stream().mapToDouble(one -> one.threshold(Chance.DEFAULT_ALPHA)).toArray();
    return new Reliability(
        groups.each(
            (group, row) -> scatters.get(group).chance(g.predicted()[row], thresholds[group])),
        groups.each((group, row) -> y[row] >= thresholds[group] ? 1 : 0));
  }

  /**
   * For each ratio of growth to least deviation the likelihood has its maximum where the errors,
   * each divided by its share, have that deviation for a root mean square; the best ratio is looked
   * for among many, and then between the neighbours of the best.
   */
  private static Residuals mostLikely(double[] gained, double[] errors) {
    double step = StrictMath.log(MOST_RATIO / LEAST_RATIO) / RATIOS;
    DoubleUnaryOperator loss = log -> loss(StrictMath.exp(log), gained, errors);
    double best =
        IntStream.rangeClosed(0, RATIOS)
            .mapToObj(i -> StrictMath.log(LEAST_RATIO) + i * step)
            .min(Comparator.comparingDouble(loss::applyAsDouble))
            .orElseThrow();
    double found =
        new BrentOptimizer(TOLERANCE, TOLERANCE)
            .optimize(
                new UnivariateObjectiveFunction(loss::applyAsDouble),
                GoalType.MINIMIZE,
                new SearchInterval(best - step, best + step, best),
                new MaxEval(MAX_STEPS))
            .getPoint();
    double ratio = loss.applyAsDouble(found) < loss(0, gained, errors) ? StrictMath.exp(found) : 0;
    double least = rms(shared(ratio, gained, errors));
    return new Residuals(rms(errors), least, ratio * least);
  }

  /** -ln of the likelihood for each photo, but for a constant. */
  private static double loss(double ratio, double[] gained, double[] errors) {
    double logs = 0;
    for (double one : gained) {
      logs += StrictMath.log(1 + ratio * one);
    }
    return logs / gained.length + StrictMath.log(rms(shared(ratio, gained, errors)));
  }

  private static double[] shared(double ratio, double[] gained, double[] errors) {
    return IntStream.range(0, errors.length)
        .mapToDouble(i -> errors[i] / (1 + ratio * gained[i]))
        .toArray();
  }

  private static double rms(double[] errors) {
    double sum = 0;
    for (double error : errors) {
      sum += error * error;
    }
    return Math.sqrt(sum / errors.length);
  }
}
