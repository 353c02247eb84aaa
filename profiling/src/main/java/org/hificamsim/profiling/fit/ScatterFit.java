package org.hificamsim.profiling.fit;

import java.util.Comparator;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;
import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * How measured confidences scatter about a g that has not seen them, and what the chances that
 * follow from it are worth.
 *
 * @param name of the kind: {@code constant} or {@code growing}
 * @param residuals of all photos
 * @param unseen of all photos but those of each group
 * @param calibration of the chances that a measured confidence reaches the threshold of the default
 *     rate of false alarms, for photos that neither g nor the residuals have seen
 * @param logLoss of such chances, the mean over the thresholds of all kinds: each kind has another
 *     threshold, and only losses about the same events can be compared
 */
public record ScatterFit(
    String name,
    Residuals residuals,
    List<Residuals> unseen,
    Calibration calibration,
    double logLoss) {
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
    Photos photos = Photos.of(g, y, groups);
    List<Residuals> constant = photos.unseen((gained, errors) -> Residuals.of(rms(errors)));
    List<Residuals> growing = photos.unseen(ScatterFit::mostLikely);
    List<List<Residuals>> all = List.of(constant, growing);
    return List.of(
        photos.fit("constant", Residuals.of(rms(photos.errors)), constant, all),
        photos.fit("growing", mostLikely(photos.gained, photos.errors), growing, all));
  }

  /** The photos as a g that has not seen them predicts them. */
  private record Photos(ShapeFit g, double[] y, Groups groups, double[] gained, double[] errors) {
    static Photos of(ShapeFit g, double[] y, Groups groups) {
      Photos photos = new Photos(g, y, groups, new double[y.length], new double[y.length]);
      forEachRow(
          groups,
          (group, row) -> {
            double background = g.fits().get(group).confidence(0);
            photos.gained[row] = Math.max(0, g.predicted()[row] - background);
            photos.errors[row] = y[row] - g.predicted()[row];
          });
      return photos;
    }

    List<Residuals> unseen(Method method) {
      return IntStream.range(0, groups.count())
          .mapToObj(groups::others)
          .map(rows -> method.fit(Groups.at(rows, gained), Groups.at(rows, errors)))
          .toList();
    }

    ScatterFit fit(
        String name, Residuals residuals, List<Residuals> unseen, List<List<Residuals>> all) {
      double loss =
          all.stream()
              .mapToDouble(one -> calibration(unseen, one).logLoss())
              .average()
              .orElseThrow();
      return new ScatterFit(name, residuals, unseen, calibration(unseen, unseen), loss);
    }

    private Calibration calibration(List<Residuals> unseen, List<Residuals> ofThreshold) {
      double[] chances = new double[y.length];
      double[] detected = new double[y.length];
      forEachRow(
          groups,
          (group, row) -> {
            DetectorModel without = g.fits().get(group);
            double threshold =
                ofThreshold.get(group).about(without).threshold(Chance.DEFAULT_ALPHA);
            chances[row] = unseen.get(group).about(without).chance(g.predicted()[row], threshold);
            detected[row] = y[row] >= threshold ? 1 : 0;
          });
      return new Calibration(chances, detected);
    }
  }

  private interface RowTask {
    void run(int group, int row);
  }

  private static void forEachRow(Groups groups, RowTask task) {
    for (int group = 0; group < groups.count(); group++) {
      for (int row : groups.rows().get(group)) {
        task.run(group, row);
      }
    }
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
