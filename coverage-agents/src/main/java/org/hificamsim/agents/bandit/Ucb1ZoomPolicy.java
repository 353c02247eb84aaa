package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.TieBreak;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The UCB1 bandit (Auer, Cesa-Bianchi and Fischer 2002): each camera uses every view once, and then
 * the one with the greatest upper confidence bound {@code mean + c sqrt(ln n / n_view)}, where n is
 * the number of its decisions so far.
 *
 * <p>Rewards are the number of detected targets divided by the number of all targets of the
 * scenario, so that they are in [0, 1] as the bound assumes.
 */
public final class Ucb1ZoomPolicy extends AbstractBanditZoomPolicy {
  private final double exploration;
  private final Ties ties;
  private TieBreak tieBreak;
  private double[][] bounds;
  private double rewardScale;

  /** Reads the options; the default of c is the square root of 2, as published. */
  public Ucb1ZoomPolicy(Options options) {
    exploration =
        options.number("c", Math.sqrt(2), 0, 1e6, "factor on the confidence interval's width");
    ties = Ties.from(options);
    readUtility(options);
  }

  @Override
  public String name() {
    return "ucb1";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    tieBreak = new TieBreak(ties, network);
    bounds = table(network);
    rewardScale = 1.0 / Math.max(1, network.targets());
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    updateBounds(bounds[camera], means(camera), pulls(camera));
    return tieBreak.best(camera, bounds[camera], 0, network.views(camera));
  }

  private void updateBounds(double[] bounds, double[] means, long[] pulls) {
    double decisions = 0;
    for (long viewPulls : pulls) {
      decisions += viewPulls;
    }
    double logarithm = StrictMath.log(Math.max(1, decisions));
    for (int view = 0; view < bounds.length; view++) {
      bounds[view] =
          pulls[view] == 0
              ? Double.POSITIVE_INFINITY
              : means[view] * rewardScale + exploration * Math.sqrt(logarithm / pulls[view]);
    }
  }
}
