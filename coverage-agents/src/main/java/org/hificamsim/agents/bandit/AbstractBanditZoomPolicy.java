package org.hificamsim.agents.bandit;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.agents.choice.Utility;
import org.hificamsim.agents.choice.ViewTable;
import org.hificamsim.core.policy.CameraTask;
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
  /** Of no instance, and small: a step of epsilon-greedy takes 1.1 times as long otherwise. */
  private static final CameraTask<AbstractBanditZoomPolicy> LEARNING =
      (network, policy, from, to) -> policy.learn(network, from, to);

  private Utility.Reading reading;
  private Utility utility;
  private ViewTable table;
  private double[] means;
  private long[] pulls;

  /** Reads the option {@code utility}; the last of a bandit's options. */
  final void readUtility(Options options) {
    reading = Utility.from(options);
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    utility = new Utility(reading, network.objective());
    table = new ViewTable(network);
    means = new double[table.size()];
    pulls = new long[table.size()];
  }

  /** Credits each online camera's current view with what it just detected. */
  @Override
  public final void learn(NetworkView network) {
    network.divide(this, LEARNING);
  }

  private void learn(NetworkView network, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        credit(table.offset(camera) + network.view(camera), utility.of(network, camera));
      }
    }
  }

  private void credit(int arm, double reward) {
    pulls[arm]++;
    means[arm] += (reward - means[arm]) / pulls[arm];
  }

  /** What a camera has learned of each view, NaN for one never used. */
  @Override
  public final String estimates(
      NetworkView network, int camera, double[] estimates, double[] counts) {
    for (int view = 0; view < network.views(camera); view++) {
      int arm = table.offset(camera) + view;
      counts[view] = pulls[arm];
      estimates[view] = pulls[arm] == 0 ? Double.NaN : means[arm];
    }
    return "mean reward";
  }

  /** The index of the camera's narrowest view among all cameras' arms. */
  final int offset(int camera) {
    return table.offset(camera);
  }

  /** Average utility, by arm; 0 for an arm never used. */
  final double[] means() {
    return means;
  }

  /** Number of times that each arm was used. */
  final long[] pulls() {
    return pulls;
  }
}
