package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.TieBreak;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The UCB1 bandit (Auer, Cesa-Bianchi and Fischer 2002): each camera uses every view once, then the
 * one with the largest upper confidence bound {@code mean + c sqrt(ln n / n_level)}, n being the
 * number of its decisions so far.
 *
 * <p>Rewards are numbers of detected targets over the number of all targets of the scenario, so in
 * [0, 1] as the bound assumes.
 */
public final class Ucb1ZoomPolicy extends AbstractBanditZoomPolicy {
  private final double exploration;
  private final Ties ties;
  private TieBreak breaking;
  private double[][] bounds;
  private double scale;

  /** Reads the options; c is the square root of 2 by default, as published. */
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
    breaking = new TieBreak(ties, network);
    bounds = table(network);
    scale = 1.0 / Math.max(1, network.targets());
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    bound(bounds[camera], means(camera), pulls(camera));
    return breaking.best(camera, bounds[camera], 0, network.views(camera));
  }

  private void bound(double[] bounds, double[] means, long[] pulls) {
    double all = 0;
    for (long own : pulls) {
      all += own;
    }
    double logarithm = StrictMath.log(Math.max(1, all));
    for (int view = 0; view < bounds.length; view++) {
      bounds[view] =
          pulls[view] == 0
              ? Double.POSITIVE_INFINITY
              : means[view] * scale + exploration * Math.sqrt(logarithm / pulls[view]);
    }
  }
}
