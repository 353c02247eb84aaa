package org.hificamsim.agents.choice;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/** Takes the best view, but explores with probability epsilon; each camera on its own. */
public final class EpsilonGreedyChoice {
  private final EpsilonSchedule schedule;
  private final Exploration exploration;
  private SplittableRandom[] randoms = {};
  private double[] epsilon = {};

  public EpsilonGreedyChoice(EpsilonSchedule schedule, Exploration exploration) {
    this.schedule = schedule;
    this.exploration = exploration;
  }

  /** The options of {@link EpsilonSchedule} and {@code explore}. */
  public static EpsilonGreedyChoice from(Options options) {
    return new EpsilonGreedyChoice(
        EpsilonSchedule.from(options),
        options.choice(
            "explore", Exploration.OTHER, "exploring draws a view other than the best, or any"));
  }

  /** Gives each camera its generator and its first epsilon. */
  public void begin(NetworkView network, SplittableRandom random) {
    randoms = CameraRandoms.split(network, random);
    epsilon = new double[network.cameras()];
    Arrays.fill(epsilon, schedule.start());
  }

  /** The camera's next view: {@code best}, or what exploring draws out of {@code views}. */
  public int choose(int camera, int views, int best) {
    double probability = epsilon[camera];
    epsilon[camera] = schedule.next(probability);
    SplittableRandom random = randoms[camera];
    return random.nextDouble() < probability ? exploration.draw(random, views, best) : best;
  }
}
