package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * The UCB1 bandit (Auer, Cesa-Bianchi and Fischer 2002): each camera uses every level once, then
 * the one with the largest upper confidence bound {@code mean + c sqrt(ln n / n_level)}, n being
 * the number of its decisions so far.
 *
 * <p>Rewards are numbers of detected targets over the number of all targets of the scenario, so in
 * [0, 1] as the bound assumes.
 */
public final class Ucb1ZoomPolicy implements ZoomPolicy {
  public static final String NAME = "ucb1";

  private final CameraTask<int[]> deciding = this::decide;
  private final double exploration;
  private final Ties ties;
  private ArmAverages arms;
  private double[] bounds;
  private double scale;

  /**
   * @param exploration the factor c on the width of the confidence interval, 0 or more
   */
  public Ucb1ZoomPolicy(double exploration, Ties ties) {
    this.exploration = exploration;
    this.ties = ties;
  }

  /** The policy with its options; c is the square root of 2 by default, as published. */
  public static Ucb1ZoomPolicy from(Options options) {
    return new Ucb1ZoomPolicy(
        options.number("c", Math.sqrt(2), 0, 1e6, "factor on the confidence interval's width"),
        Ties.from(options, Ties.WIDEST));
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    arms = new ArmAverages(network);
    bounds = new double[arms.means().length];
    scale = 1.0 / Math.max(1, network.targets());
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    network.divide(levels, deciding);
  }

  private void decide(NetworkView network, int[] levels, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        bound(arms.offset(camera), network.levels(camera));
        levels[camera] = ties.best(bounds, arms.offset(camera), network.levels(camera));
      }
    }
  }

  @Override
  public void learn(NetworkView network) {
    arms.learn(network);
  }

  @Override
  public String estimates(NetworkView network, int camera, double[] estimates, double[] counts) {
    return arms.estimates(network, camera, estimates, counts);
  }

  private void bound(int offset, int levels) {
    double pulls = 0;
    for (int arm = offset; arm < offset + levels; arm++) {
      pulls += arms.pulls()[arm];
    }
    double logarithm = StrictMath.log(Math.max(1, pulls));
    for (int arm = offset; arm < offset + levels; arm++) {
      long own = arms.pulls()[arm];
      bounds[arm] =
          own == 0
              ? Double.POSITIVE_INFINITY
              : arms.means()[arm] * scale + exploration * Math.sqrt(logarithm / own);
    }
  }
}
