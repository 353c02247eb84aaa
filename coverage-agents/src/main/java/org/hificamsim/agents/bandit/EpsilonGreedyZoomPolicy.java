package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.choice.TieBreak;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The epsilon-greedy bandit (thesis 7.4.3, Eq 7.3): each camera takes the view with the best
 * average number of detected targets, and explores with probability epsilon.
 *
 * <p>The average of a view that was never used is 0. Options decide what the thesis leaves open:
 * which of equally good views is best ({@code ties}), what exploring draws from ({@code explore}),
 * and whether epsilon decays ({@code epsilon-decay}, {@code epsilon-min}).
 */
public final class EpsilonGreedyZoomPolicy extends AbstractBanditZoomPolicy {
  private final EpsilonGreedyChoice choice;
  private final Ties ties;
  private TieBreak tieBreak;

  /** Reads the options, whose defaults reproduce the thesis. */
  public EpsilonGreedyZoomPolicy(Options options) {
    choice = new EpsilonGreedyChoice(options);
    ties = Ties.from(options);
    readUtility(options);
  }

  @Override
  public String name() {
    return "epsilon-greedy";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    super.begin(network, random);
    tieBreak = new TieBreak(ties, network);
    choice.begin(network, random);
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    int views = network.views(camera);
    return choice.choose(camera, views, tieBreak.best(camera, means(camera), 0, views));
  }
}
