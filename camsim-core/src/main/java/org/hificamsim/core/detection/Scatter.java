package org.hificamsim.core.detection;

/**
 * The scatter of measured confidences about a model's values: a target with value v is measured
 * with a confidence of v + e, where e is normal with mean 0 and standard deviation {@code least +
 * growth * (v - background)}.
 *
 * @param background the value of a target that fills nothing of the image
 * @param rmse the root mean square of e over all measurements, above 0
 * @param least the standard deviation at the background, above 0
 * @param growth the increase of the standard deviation for each unit of the value above the
 *     background, 0 or more
 */
public record Scatter(double background, double rmse, double least, double growth) {
  private static final double ROUNDING = 1e-12;

  /**
   * Creates a scatter that is equal for all values.
   *
   * @param rmse the standard deviation of e
   */
  public Scatter(double background, double rmse) {
    this(background, rmse, rmse, 0);
  }

  /** The standard deviation of measurements of targets with this value. */
  public double deviation(double value) {
    return least + growth * Math.max(0, value - background);
  }

  /**
   * Returns the confidence that a share of the measurements of the background reaches.
   *
   * @param tail the share, in (0, 1)
   */
  public double threshold(double tail) {
    return background + NormalDistribution.quantile(1 - tail) * rmse;
  }

  /** The chance that the background is measured with a confidence of at least a threshold. */
  public double falseAlarms(double threshold) {
    return chanceOfReaching(background, threshold);
  }

  /**
   * The chance that a target is measured with a confidence of at least a threshold, without those
   * measurements that would be false alarms; in [0, 1], 0 if the value is NaN.
   *
   * @param value the value of the model
   */
  public double chance(double value, double threshold) {
    double gain = chanceOfReaching(value, threshold) - falseAlarms(threshold);
    return gain > ROUNDING ? gain / (1 - falseAlarms(threshold)) : 0;
  }

  private double chanceOfReaching(double value, double threshold) {
    return NormalDistribution.cdf((value - threshold) / deviation(value));
  }

  /**
   * Returns the value whose {@link #chance} is one half; infinite if the scatter grows so fast that
   * there is none.
   *
   * @param threshold the background or more
   */
  public double half(double threshold) {
    double deviations = NormalDistribution.quantile((1 + falseAlarms(threshold)) / 2);
    double gain = (threshold - background + deviations * least) / (1 - deviations * growth);
    return deviations * growth < 1 ? background + gain : Double.POSITIVE_INFINITY;
  }
}
