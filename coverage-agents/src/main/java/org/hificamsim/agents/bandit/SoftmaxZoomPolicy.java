package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The softmax bandit: each camera draws its view with a probability proportional to {@code
 * exp(average / temperature)}, where the average is that of the numbers of detected targets.
 */
public final class SoftmaxZoomPolicy extends AbstractBanditZoomPolicy {
  private final double temperature;
  private double[][] weights;
  private SplittableRandom[] randoms;

  /** Reads the temperature, with CamSim's as its default, and what is rewarded. */
  public SoftmaxZoomPolicy(Options options) {
    temperature = options.number("temperature", 0.1, 1e-6, 1e6, "in targets; smaller is greedier");
    readUtility(options);
  }

  @Override
  public String name() {
    return "softmax";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    weights = table(network);
    randoms = split(network, random);
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    double sum = updateWeights(means(camera), weights[camera]);
    return view(randoms[camera].nextDouble() * sum, weights[camera]);
  }

  /**
   * Computes the weights of views relative to the greatest average, so that none overflows.
   *
   * @return the sum of the weights
   */
  private double updateWeights(double[] means, double[] weights) {
    double greatest = 0;
    for (double mean : means) {
      greatest = Math.max(greatest, mean);
    }
    double sum = 0;
    for (int view = 0; view < means.length; view++) {
      weights[view] = StrictMath.exp((means[view] - greatest) / temperature);
      sum += weights[view];
    }
    return sum;
  }

  private static int view(double drawn, double[] weights) {
    double rest = drawn;
    int view = 0;
    while (view < weights.length - 1 && rest >= weights[view]) {
      rest -= weights[view];
      view++;
    }
    return view;
  }
}
