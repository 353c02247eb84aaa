package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The softmax bandit: each camera draws its view with probability proportional to {@code
 * exp(average / temperature)}, the average being of numbers of detected targets.
 */
public final class SoftmaxZoomPolicy extends AbstractBanditZoomPolicy {
  private final double temperature;
  private double[][] weights;
  private SplittableRandom[] randoms;

  /** Reads the temperature, by default CamSim's, and what is rewarded. */
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
    double sum = weigh(means(camera), weights[camera]);
    return viewAt(randoms[camera].nextDouble() * sum, weights[camera]);
  }

  /** Weighs relative to the largest average, whose weight is 1: nothing overflows. */
  private double weigh(double[] means, double[] weights) {
    double most = 0;
    for (double mean : means) {
      most = Math.max(most, mean);
    }
    double sum = 0;
    for (int view = 0; view < means.length; view++) {
      weights[view] = StrictMath.exp((means[view] - most) / temperature);
      sum += weights[view];
    }
    return sum;
  }

  private static int viewAt(double drawn, double[] weights) {
    double left = drawn;
    int view = 0;
    while (view < weights.length - 1 && left >= weights[view]) {
      left -= weights[view];
      view++;
    }
    return view;
  }
}
