package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;

/**
 * K-fold cross-validation (thesis 4.4): every observation is predicted by a fit that has not seen
 * it.
 *
 * @param folds the R2 of each fold
 * @param predicted the held-out prediction of each observation's {@code -log10(PIP)}
 */
public record CrossValidation(double[] folds, double[] predicted) {
  /**
   * Fits {@code k} times.
   *
   * @param seed of the shuffle that deals the observations to the folds
   * @throws InputException when there are too few observations
   */
  public static CrossValidation of(
      FeatureRegression regression, List<Observation> observations, int k, long seed) {
    if (observations.size() < 2 * k) {
      throw new InputException(
          "%s rows, expected at least %s for %s folds".formatted(observations.size(), 2 * k, k));
    }
    int[] order = shuffled(observations.size(), seed);
    double[] folds = new double[k];
    double[] predicted = new double[order.length];
    for (int fold = 0; fold < k; fold++) {
      folds[fold] = fold(regression, observations, order, fold, k, predicted);
    }
    return new CrossValidation(folds, predicted);
  }

  /** The mean of the folds' R2. */
  public double mean() {
    return Arrays.stream(folds).average().orElseThrow();
  }

  /** The standard deviation of the folds' R2. */
  public double deviation() {
    double mean = mean();
    double sum = 0;
    for (double fold : folds) {
      sum += (fold - mean) * (fold - mean);
    }
    return Math.sqrt(sum / (folds.length - 1));
  }

  private static double fold(
      FeatureRegression regression,
      List<Observation> observations,
      int[] order,
      int fold,
      int k,
      double[] predicted) {
    List<Observation> training = new ArrayList<>();
    List<Integer> held = new ArrayList<>();
    for (int i = 0; i < order.length; i++) {
      if (i % k == fold) {
        held.add(order[i]);
      } else {
        training.add(observations.get(order[i]));
      }
    }
    FittedFeature fit = regression.fit(training);
    double[] truth = new double[held.size()];
    double[] guess = new double[held.size()];
    for (int i = 0; i < truth.length; i++) {
      Observation o = observations.get(held.get(i));
      truth[i] = o.response();
      guess[i] = fit.response(o);
      predicted[held.get(i)] = guess[i];
    }
    return Scores.of(truth, guess).r2();
  }

  private static int[] shuffled(int size, long seed) {
    int[] order = IntStream.range(0, size).toArray();
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = size - 1; i > 0; i--) {
      int j = random.nextInt(i + 1);
      int swapped = order[i];
      order[i] = order[j];
      order[j] = swapped;
    }
    return order;
  }
}
