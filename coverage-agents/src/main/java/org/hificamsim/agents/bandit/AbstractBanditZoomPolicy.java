package org.hificamsim.agents.bandit;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The learning that all bandits share: for each camera and view, which are the arms, the number of
 * times that the view was used, and the average reward.
 *
 * <p>The reward is the utility U_i of Eq 7.3, the number of targets that the camera detected, or
 * its share of another objective ({@link Utility}). The factor lambda of that equation scales all
 * averages equally, and so changes no comparison.
 */
abstract class AbstractBanditZoomPolicy extends AbstractDistributedZoomPolicy {
  private Utility.Reading reading;
  private Utility utility;

  /** The mean reward by camera and view. */
  private double[][] means;

  /** The number of rewards in each mean, by camera and view. */
  private long[][] pulls;

  /** Reads the option {@code utility}, which is the last option of each bandit. */
  final void readUtility(Options options) {
    reading = Utility.from(options);
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    utility = new Utility(reading, network.objective());
    means = table(network);
    pulls = new long[network.cameras()][];
    Arrays.setAll(pulls, camera -> new long[network.views(camera)]);
  }

  /** Returns an array with a number for each camera and view. */
  static double[][] table(NetworkView network) {
    double[][] table = new double[network.cameras()][];
    Arrays.setAll(table, camera -> new double[network.views(camera)]);
    return table;
  }

  /** Rewards the present view of each online camera for what the camera has just detected. */
  @Override
  public final void learn(NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        reward(
            means[camera], pulls[camera], network.view(camera), utility.compute(network, camera));
      }
    }
  }

  private static void reward(double[] means, long[] pulls, int view, double reward) {
    pulls[view]++;
    means[view] += (reward - means[view]) / pulls[view];
  }

  /** Reports the average reward of each view, NaN if the view was never used. */
  @Override
  public final String estimates(int camera, double[] estimates, double[] counts) {
    for (int view = 0; view < means[camera].length; view++) {
      counts[view] = pulls[camera][view];
      estimates[view] = pulls[camera][view] == 0 ? Double.NaN : means[camera][view];
    }
    return "mean reward";
  }

  /** The average reward of each view of a camera; 0 if the view was never used. */
  final double[] means(int camera) {
    return means[camera];
  }

  /** The number of times that a camera used each view. */
  final long[] pulls(int camera) {
    return pulls[camera];
  }
}
