package org.hificamsim.core.detection;

/**
 * How measured confidences scatter about a model's values: a target whose value is v was measured
 * with a confidence of v + e, where e is normal with mean 0 and standard deviation {@code least +
 * growth * (v - background)}.
 *
 * @param background the value where the target fills nothing of the image
 * @param rmse the root mean square of e over all that was measured, above 0
 * @param least the standard deviation at the background, above 0
 * @param growth what it gains for each unit of the value above the background, 0 or more
 */
public record Scatter(double background, double rmse, double least, double growth) {
  private static final double ROUNDING = 1e-12;

  /**
   * The same scatter everywhere.
   *
   * @param rmse the standard deviation of e
   */
  public Scatter(double background, double rmse) {
    this(background, rmse, rmse, 0);
  }

  /** The standard deviation of what is measured where the model has this value. */
  public double deviation(double value) {
    return least + growth * Math.max(0, value - background);
  }

  /**
   * The measured confidence above the background that a tail of all that was measured reaches.
   *
   * @param tail the share of a normal distribution, in (0, 1)
   */
  public double threshold(double tail) {
    return background + NormalDistribution.quantile(1 - tail) * rmse;
  }

  /** How likely what fills nothing of the image is measured with a threshold or more. */
  public double falseAlarms(double threshold) {
    return reaching(background, threshold);
  }

  /**
   * The chance that a target is measured with a threshold or more and is no false alarm, which
   * happens whether it is there or not; in [0, 1], 0 where the value is NaN.
   *
   * @param value of the model
   */
  public double chance(double value, double threshold) {
    double gained = reaching(value, threshold) - falseAlarms(threshold);
    return gained > ROUNDING ? gained / (1 - falseAlarms(threshold)) : 0;
  }

  private double reaching(double value, double threshold) {
    return NormalDistribution.cdf((value - threshold) / deviation(value));
  }

  /**
   * The value with a {@link #chance} of one half; infinite where the scatter grows so fast that
   * none has it.
   *
   * @param threshold the background or more
   */
  public double half(double threshold) {
    double deviations = NormalDistribution.quantile((1 + falseAlarms(threshold)) / 2);
    double gained = (threshold - background + deviations * least) / (1 - deviations * growth);
    return deviations * growth < 1 ? background + gained : Double.POSITIVE_INFINITY;
  }
}
