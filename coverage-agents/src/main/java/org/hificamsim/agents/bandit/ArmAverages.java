package org.hificamsim.agents.bandit;

import org.hificamsim.agents.choice.LevelTable;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;

/**
 * What every bandit here learns: for each camera and level, how often the level was used and the
 * average number of targets detected with it.
 *
 * <p>The reward is the utility U_i of Eq 7.3, the number of targets that the camera detected. The
 * factor lambda of that equation scales all averages alike and so changes no comparison of them.
 */
final class ArmAverages {
  private static final CameraTask<ArmAverages> LEARNING = ArmAverages::learn;

  private final LevelTable table;
  private final double[] means;
  private final long[] pulls;

  ArmAverages(NetworkView network) {
    table = new LevelTable(network);
    means = new double[table.size()];
    pulls = new long[table.size()];
  }

  /** Credits each online camera's current level with what it just detected. */
  void learn(NetworkView network) {
    network.divide(this, LEARNING);
  }

  private static void learn(NetworkView network, ArmAverages arms, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        arms.credit(arms.offset(camera) + network.level(camera), network.detected(camera));
      }
    }
  }

  private void credit(int arm, int detected) {
    pulls[arm]++;
    means[arm] += (detected - means[arm]) / pulls[arm];
  }

  /**
   * Copies what a camera has learned of each level, NaN for one never used.
   *
   * @return what the averages are of
   */
  String estimates(NetworkView network, int camera, double[] estimates, double[] counts) {
    int offset = offset(camera);
    for (int level = 0; level < network.levels(camera); level++) {
      counts[level] = pulls[offset + level];
      estimates[level] = counts[level] == 0 ? Double.NaN : means[offset + level];
    }
    return "mean reward";
  }

  /** The index in {@link #means} and {@link #pulls} of the camera's narrowest level. */
  int offset(int camera) {
    return table.offset(camera);
  }

  /** Average number of targets detected, by arm; 0 for an arm never used. */
  double[] means() {
    return means;
  }

  /** Number of times that each arm was used. */
  long[] pulls() {
    return pulls;
  }
}
