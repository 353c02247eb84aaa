package org.hificamsim.agents.temporal;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * The parts of its picture in which a camera sees targets: the left, centre or right third of its
 * opening angle; and, if depth counts, near or far, that is within half the {@linkplain
 * NetworkView#reach reach} of its view or beyond. A percept is a number: bit 0 stands for left, 1
 * for centre, 2 for right, and the next three bits for the same parts far away.
 */
final class PicturePercept {
  static final int THIRDS = 3;

  private final boolean depth;
  private final SeenPairs pairs = new SeenPairs();

  /** The bits of the parts with targets, by camera. */
  private final int[] percepts;

  PicturePercept(int cameras, boolean depth) {
    this.depth = depth;
    percepts = new int[cameras];
  }

  /** Updates what all cameras see now; a camera that moves blindly sees nothing. */
  void update(NetworkView network) {
    network.findSeen(pairs);
    Arrays.fill(percepts, 0);
    for (int i = 0; i < pairs.count(); i++) {
      percepts[pairs.camera(i)] |= partBit(network, pairs.camera(i), pairs.target(i));
    }
  }

  private int partBit(NetworkView network, int camera, int target) {
    int view = network.seeing(camera);
    double halfThird = network.zoom(camera, view).viewingAngle() / THIRDS / 2;
    double bearing = network.bearing(camera, target);
    int third = Math.abs(bearing) <= halfThird ? 1 : bearing < 0 ? 0 : 2;
    boolean far = depth && network.distance(camera, target) > network.reach(camera, view) / 2;
    return 1 << (far ? THIRDS + third : third);
  }

  /** The percept of a camera at the last {@link #update}. */
  int lastPercept(int camera) {
    return percepts[camera];
  }

  /** Computes what a camera sees now. */
  int presentPercept(NetworkView network, int camera) {
    int percept = 0;
    for (int target = 0; target < network.targets(); target++) {
      percept |= network.sees(camera, target) ? partBit(network, camera, target) : 0;
    }
    return percept;
  }
}
