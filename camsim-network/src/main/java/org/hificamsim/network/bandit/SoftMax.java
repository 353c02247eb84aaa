package org.hificamsim.network.bandit;

import java.util.Random;

/**
 * An arm with a probability that grows with the exponential of its mean.
 *
 * @param temperature the higher, the more alike the arms
 */
record SoftMax(double temperature) implements ArmChoice {
  @Override
  public int choose(Arms arms, Random random) {
    double sum = 0.0;
    for (int arm = 0; arm < Arms.COUNT; arm++) {
      sum += weight(arms, arm);
    }
    double left = random.nextDouble() * sum;
    int next = 0;
    while (left > 0 && next < Arms.COUNT) {
      left -= weight(arms, next++);
    }
    return next - 1;
  }

  private double weight(Arms arms, int arm) {
    return Math.exp(arms.mean(arm) / temperature);
  }
}
