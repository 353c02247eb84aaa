package org.hificamsim.agents.bandit;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * What every bandit here learns: for each camera and view, its arms, how often the view was used
 * and the average number of targets detected with it.
 *
 * <p>The reward is the utility U_i of Eq 7.3, the number of targets that the camera detected, or
 * its share of another objective ({@link Utility}). The factor lambda of that equation scales all
 * averages by the same and so changes no comparison.
 */
abstract class AbstractBanditZoomPolicy extends AbstractDistributedZoomPolicy {
  private Utility.Reading reading;
  private Utility utility;
  private double[][] means; // by camera and view
  private long[][] pulls;

  /** Reads the option {@code utility}; the last of a bandit's options. */
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

  /** Room for a number for each camera and view. */
  static double[][] table(NetworkView network) {
    double[][] table = new double[network.cameras()][];
    Arrays.setAll(table, camera -> new double[network.views(camera)]);
    return table;
  }

  /** Credits each online camera's current view with what it just detected. */
  @Override
  public final void learn(NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        credit(means[camera], pulls[camera], network.view(camera), utility.of(network, camera));
      }
    }
  }

  private static void credit(double[] means, long[] pulls, int view, double reward) {
    pulls[view]++;
    means[view] += (reward - means[view]) / pulls[view];
  }

  /** What a camera has learned of each view, NaN for one never used. */
  @Override
  public final String estimates(int camera, double[] estimates, double[] counts) {
    for (int view = 0; view < means[camera].length; view++) {
      counts[view] = pulls[camera][view];
      estimates[view] = pulls[camera][view] == 0 ? Double.NaN : means[camera][view];
    }
    return "mean reward";
  }

  /** A camera's average utility, by view; 0 for one never used. */
  final double[] means(int camera) {
    return means[camera];
  }

  /** How often a camera used each view. */
  final long[] pulls(int camera) {
    return pulls[camera];
  }
}
