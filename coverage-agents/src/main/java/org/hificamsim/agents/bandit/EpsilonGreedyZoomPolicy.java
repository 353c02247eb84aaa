package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.EpsilonGreedyChoice;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * The epsilon-greedy bandit (section 7.4.3, Eq 7.3): each camera takes the level with the best
 * average number of detected targets, and explores with probability epsilon.
 *
 * <p>A level never used counts as 0. Open in the thesis and so an option: which of equally good
 * levels is best ({@code ties}), what exploring draws from ({@code explore}), whether epsilon
 * decays ({@code epsilon-decay}, {@code epsilon-min}).
 */
public final class EpsilonGreedyZoomPolicy implements ZoomPolicy {
  public static final String NAME = "epsilon-greedy";

  private final CameraTask<int[]> deciding = this::decide;
  private final EpsilonGreedyChoice choice;
  private final Ties ties;
  private ArmAverages arms;

  public EpsilonGreedyZoomPolicy(EpsilonGreedyChoice choice, Ties ties) {
    this.choice = choice;
    this.ties = ties;
  }

  /** The policy with its options, each with the default that reproduces the thesis. */
  public static EpsilonGreedyZoomPolicy from(Options options) {
    return new EpsilonGreedyZoomPolicy(
        EpsilonGreedyChoice.from(options), Ties.from(options, Ties.WIDEST));
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    arms = new ArmAverages(network);
    choice.begin(network, random);
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    network.divide(levels, deciding);
  }

  private void decide(NetworkView network, int[] levels, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        int count = network.levels(camera);
        int best = ties.best(arms.means(), arms.offset(camera), count);
        levels[camera] = choice.choose(camera, count, best);
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
}
