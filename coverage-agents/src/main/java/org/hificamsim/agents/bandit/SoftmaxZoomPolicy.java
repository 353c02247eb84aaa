package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The softmax bandit: each camera draws its view with probability proportional to {@code
 * exp(average / temperature)}, the average being of numbers of detected targets.
 */
public final class SoftmaxZoomPolicy extends AbstractBanditZoomPolicy {
  public static final String NAME = "softmax";

  private final double temperature;
  private double[] weights;
  private SplittableRandom[] randoms;

  /** Reads the temperature, by default CamSim's, and what is rewarded. */
  public SoftmaxZoomPolicy(Options options) {
    temperature = options.number("temperature", 0.1, 1e-6, 1e6, "in targets; smaller is greedier");
    readUtility(options);
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    weights = new double[means().length];
    randoms = split(network, random);
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    double sum = weigh(offset(camera), network.views(camera));
    double drawn = randoms[camera].nextDouble() * sum;
    return levelAt(drawn, offset(camera), network.views(camera));
  }

  /** Weighs relative to the largest average, whose weight is 1: nothing overflows. */
  private double weigh(int offset, int views) {
    double most = 0;
    for (int arm = offset; arm < offset + views; arm++) {
      most = Math.max(most, means()[arm]);
    }
    double sum = 0;
    for (int arm = offset; arm < offset + views; arm++) {
      weights[arm] = StrictMath.exp((means()[arm] - most) / temperature);
      sum += weights[arm];
    }
    return sum;
  }

  private int levelAt(double drawn, int offset, int views) {
    double left = drawn;
    int view = 0;
    while (view < views - 1 && left >= weights[offset + view]) {
      left -= weights[offset + view];
      view++;
    }
    return view;
  }
}
