package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;

/**
 * A validation of f: every observation is predicted by a fit that has not seen it, nor the others
 * of its group (thesis 4.4 with folds for groups).
 *
 * @param fits the fit that has not seen each group
 * @param folds the R2 within each group
 * @param predicted the held-out prediction of each observation's {@code -log10(PIP)}
 * @param r2 of all these predictions together
 */
public record CrossValidation(
    List<FittedFeature> fits, double[] folds, double[] predicted, double r2) {
  /**
   * Fits {@code k} times.
   *
   * @param seed of the shuffle that deals the observations to the folds
   * @throws InputException when there are too few observations
   */
  public static CrossValidation of(
      FeatureRegression regression, List<Observation> observations, int k, long seed) {
    Groups groups = folds(observations.size(), k, seed);
    List<FittedFeature> fits =
        IntStream.range(0, k)
            .mapToObj(fold -> regression.fit(Groups.at(groups.others(fold), observations)))
            .toList();
    return of(groups, fits, observations);
  }

  /** K folds, each of which has two observations or more. */
  static Groups folds(int observations, int k, long seed) {
    if (observations < 2 * k) {
      throw new InputException(
          "%s rows, expected at least %s for %s folds".formatted(observations, 2 * k, k));
    }
    return Groups.folds(observations, k, seed);
  }

  /** What the fits say of the groups that they have not seen. */
  static CrossValidation of(
      Groups groups, List<FittedFeature> fits, List<Observation> observations) {
    double[] observed = observations.stream().mapToDouble(Observation::response).toArray();
    double[] predicted = new double[observed.length];
    double[] folds = new double[groups.count()];
    for (int group = 0; group < folds.length; group++) {
      int[] held = groups.rows().get(group);
      for (int row : held) {
        predicted[row] = fits.get(group).response(observations.get(row));
      }
      folds[group] = Scores.of(Groups.at(held, observed), Groups.at(held, predicted)).r2();
    }
    return new CrossValidation(fits, folds, predicted, Scores.of(observed, predicted).r2());
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
}
