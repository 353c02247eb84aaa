package org.hificamsim.agents.cooperative;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;

/**
 * Log-linear learning (Marden, Arslan and Shamma, 2009; spatial adaptive play): one camera at a
 * time, drawn at random, draws its next view with a chance that rises exponentially with what the
 * view adds. That is a potential game; the less noise, the more often it is in its best state.
 * Noise falls to none, where a camera takes its best view.
 */
final class LogLinearLearning implements Agreement {
  private static final double NOISE = 0.3; // of targets, at first

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
    Agreement.greedy(network, team, 1);
    int cameras = network.cameras();
    for (int round = 0; round < rounds; round++) {
      double noise = NOISE * (rounds - 1 - round) / rounds;
      for (int i = 0; i < cameras; i++) {
        int camera = random.nextInt(cameras);
        if (network.online(camera)) {
          team.choose(network, camera, draw(network, team.plan(camera), camera, noise));
        }
      }
    }
  }

  private int draw(NetworkView network, Plan plan, int camera, double noise) {
    int best = plan.best(network, camera);
    if (noise == 0) {
      return best;
    }
    double most = plan.gain(best);
    double sum = 0;
    for (int view = 0; view < network.views(camera); view++) {
      sum += Math.exp((plan.gain(view) - most) / noise);
    }
    double left = random.nextDouble() * sum;
    int view = -1;
    do {
      view++;
      left -= Math.exp((plan.gain(view) - most) / noise);
    } while (left > 0 && view + 1 < network.views(camera));
    return view;
  }
}
