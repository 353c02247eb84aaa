package org.hificamsim.agents.cooperative;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;

/**
 * Log-linear learning (Marden, Arslan and Shamma, 2009; spatial adaptive play). One camera at a
 * time, drawn at random, draws its next view, with a chance that rises exponentially with what the
 * view adds. In this potential game, the best joint choice is the more likely, the less noise there
 * is. The noise falls to 0 in the last round, in which cameras take their best views. Before the
 * first round, each camera chooses once in turn.
 */
final class LogLinearLearning implements Agreement {
  /** The noise of the first round, in units of what a view adds. */
  private static final double FIRST_NOISE = 0.3;

  private final int rounds;
  private final SplittableRandom random;

  /**
   * @param rounds how often each camera chooses, on average
   */
  LogLinearLearning(int rounds, SplittableRandom random) {
    this.rounds = rounds;
    this.random = random;
  }

  @Override
  public void agree(NetworkView network, Team team) {
    Agreement.chooseInTurn(network, team, 1);
    int cameras = network.cameras();
    for (int round = 0; round < rounds; round++) {
      double noise = FIRST_NOISE * (rounds - 1 - round) / rounds;
      for (int i = 0; i < cameras; i++) {
        int camera = random.nextInt(cameras);
        if (network.online(camera)) {
          team.choose(network, camera, draw(network, team.plan(camera), camera, noise));
        }
      }
    }
  }

  private int draw(NetworkView network, Plan plan, int camera, double noise) {
    plan.withdraw(camera);
    double[] gains = plan.gains(network, camera);
    int best = plan.best(network, camera, gains);
    if (noise == 0) {
      return best;
    }
    int views = network.views(camera);
    double sum = 0;
    for (int view = 0; view < views; view++) {
      sum += Math.exp((gains[view] - gains[best]) / noise);
    }
    double remainder = random.nextDouble() * sum;
    int view = -1;
    do {
      view++;
      remainder -= Math.exp((gains[view] - gains[best]) / noise);
    } while (remainder > 0 && view + 1 < views);
    return view;
  }
}
