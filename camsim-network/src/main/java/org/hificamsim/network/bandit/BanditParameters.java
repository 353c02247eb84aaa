package org.hificamsim.network.bandit;

/**
 * The parameters of a bandit (behaviour 9.1).
 *
 * @param epsilon the probability of exploring, temperature of SoftMax, or alpha of UCB2
 * @param alpha the weight of performance against communication, or of the targets kept in view
 * @param beta the weight of the targets that other cameras also see; zoom only
 * @param gamma the weight of the confidences; zoom only
 * @param interval the number of steps between two choices, 1 or more
 */
public record BanditParameters(
    double epsilon, double alpha, double beta, double gamma, int interval) {
  /** CamSim's defaults. */
  public static final BanditParameters DEFAULT = new BanditParameters(0.1, 0.5, 0.5, 0, 1);

  /** Returns these parameters with another weight of performance. */
  public BanditParameters withAlpha(double newAlpha) {
    return new BanditParameters(epsilon, newAlpha, beta, gamma, interval);
  }

  /**
   * Returns the parameters that an algorithm uses: epsilon-greedy and UCB1 ignore beta and gamma.
   */
  BanditParameters usedBy(BanditAlgorithm algorithm) {
    boolean ignoresZoomWeights =
        algorithm == BanditAlgorithm.EPSILON_GREEDY || algorithm == BanditAlgorithm.UCB1;
    return ignoresZoomWeights ? new BanditParameters(epsilon, alpha, 0, 0, interval) : this;
  }
}
