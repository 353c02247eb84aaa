package org.hificamsim.network.bandit;

/**
 * The parameters of a bandit (behaviour 9.1).
 *
 * @param epsilon chance of exploring, temperature of SoftMax, or alpha of UCB2
 * @param alpha weight of performance against communication, or of the targets kept in view
 * @param beta weight of the targets that others see too; zoom only
 * @param gamma weight of the confidences; zoom only
 * @param interval steps between two choices, 1 or more
 */
public record BanditParameters(
    double epsilon, double alpha, double beta, double gamma, int interval) {
  /** CamSim's defaults. */
  public static final BanditParameters DEFAULT = new BanditParameters(0.1, 0.5, 0.5, 0, 1);

  /** The same with another weight of performance. */
  public BanditParameters withAlpha(double newAlpha) {
    return new BanditParameters(epsilon, newAlpha, beta, gamma, interval);
  }

  /** What an algorithm takes of them: two know neither beta nor gamma. */
  BanditParameters of(BanditAlgorithm algorithm) {
    boolean dropped =
        algorithm == BanditAlgorithm.EPSILON_GREEDY || algorithm == BanditAlgorithm.UCB1;
    return dropped ? new BanditParameters(epsilon, alpha, 0, 0, interval) : this;
  }
}
