package org.hificamsim.core.detection;

/**
 * How measured confidences scatter about a model's values: a target whose value is v was measured
 * with a confidence of v + e, where e is normal with mean 0 and standard deviation {@code least +
 * growth * (v - background)}.
 *
 * @param background the value where the target fills nothing of the image
 * @param least the standard deviation there, above 0
 * @param growth what it gains for each unit of the value above the background, 0 or more
 */
public record Scatter(double background, double least, double growth) {
  /**
   * The same scatter everywhere.
   *
   * @param rmse the fit's root mean squared error
   */
  public Scatter(double background, double rmse) {
    this(background, rmse, 0);
  }

  /** The standard deviation of what is measured where the model has this value. */
  public double deviation(double value) {
    return least + growth * Math.max(0, value - background);
  }

  /**
   * The measured confidence that a target which fills nothing of the image reaches by chance.
   *
   * @param falseAlarms that chance, in (0, 1)
   */
  public double threshold(double falseAlarms) {
    return background + NormalDistribution.quantile(1 - falseAlarms) * least;
  }

  /** The chance that the confidence measured reaches a threshold where the value is this. */
  public double chance(double value, double threshold) {
    return NormalDistribution.cdf((value - threshold) / deviation(value));
  }

  /**
   * The value whose measured confidence reaches a threshold with a chance; infinite where the
   * scatter grows so fast that none does.
   *
   * @param threshold the background or more
   * @param chance in [0.5, 1)
   */
  public double value(double threshold, double chance) {
    double deviations = NormalDistribution.quantile(chance);
    double gained = (threshold - background + deviations * least) / (1 - deviations * growth);
    return deviations * growth < 1 ? background + gained : Double.POSITIVE_INFINITY;
  }
}
