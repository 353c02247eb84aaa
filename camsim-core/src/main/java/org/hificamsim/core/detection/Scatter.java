package org.hificamsim.core.detection;

/**
 * How measured confidences scatter about a model's values: a target whose value is v was measured
 * with a confidence of v + e, where e is normal with mean 0.
 *
 * @param background the value where the target fills nothing of the image
 * @param rmse the standard deviation of e: the fit's root mean squared error, above 0
 */
public record Scatter(double background, double rmse) {
  /**
   * The threshold that a target which fills nothing of the image reaches by chance.
   *
   * @param falseAlarms that chance, in (0, 1)
   */
  public double threshold(double falseAlarms) {
    return background + NormalDistribution.quantile(1 - falseAlarms) * rmse;
  }

  /** The chance that the confidence measured reaches a threshold where the value is this. */
  public double chance(double value, double threshold) {
    return NormalDistribution.cdf((value - threshold) / rmse);
  }
}
