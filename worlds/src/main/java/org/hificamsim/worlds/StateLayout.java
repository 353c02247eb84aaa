package org.hificamsim.worlds;

import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Field;

/**
 * The state of a world as numbers in [-1, 1], for critics that may know everything: how much of the
 * episode is over; of each camera what it knows of itself; of each target whether it is there, its
 * x and y as parts of the field, and the share of the cameras that detected it in the last step.
 */
final class StateLayout {
  private static final int TARGET = 4;

  private StateLayout() {}

  static int size(int cameras, int targets) {
    return 1 + cameras * ObservationLayout.OWN_SIZE + targets * TARGET;
  }

  /**
   * Writes the state.
   *
   * @param observations of all cameras
   * @param each how many numbers a camera's observation has
   */
  static void write(
      OracleView network, Field field, double over, float[] observations, int each, float[] out) {
    out[0] = (float) over;
    int at = 1;
    for (int camera = 0; camera < network.cameras(); camera++) {
      System.arraycopy(observations, camera * each, out, at, ObservationLayout.OWN_SIZE);
      at += ObservationLayout.OWN_SIZE;
    }
    for (int target = 0; target < network.targets(); target++) {
      boolean present = network.present(target);
      out[at] = present ? 1 : 0;
      out[at + 1] = present ? part(network.targetX(target), field.minX(), field.width()) : 0;
      out[at + 2] = present ? part(network.targetY(target), field.minY(), field.height()) : 0;
      out[at + 3] = present ? (float) network.coverage(target) / network.cameras() : 0;
      at += TARGET;
    }
  }

  private static float part(double at, double least, double length) {
    double part = (at - least) / length;
    return part >= 0 && part <= 1 ? (float) part : part > 1 ? 1 : 0;
  }
}
