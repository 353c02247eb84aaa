package org.hificamsim.agents.temporal;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;

/**
 * Where in its picture each camera sees targets: in the left, centre or right third of its opening
 * angle, and, where depth counts, near or far: up to half the {@linkplain NetworkView#reach reach}
 * of its view, or farther. As a number: bit 0 for left, 1 for centre, 2 for right, then the same
 * for far.
 */
final class PicturePercept {
  static final int THIRDS = 3;

  private final boolean depth;
  private final SeenPairs pairs = new SeenPairs();
  private final int[] parts; // by camera

  PicturePercept(int cameras, boolean depth) {
    this.depth = depth;
    parts = new int[cameras];
  }

  /** Looks at what all cameras see where all are now; one that moves blindly sees nothing. */
  void look(NetworkView network) {
    network.findSeen(pairs);
    Arrays.fill(parts, 0);
    for (int i = 0; i < pairs.count(); i++) {
      parts[pairs.camera(i)] |= part(network, pairs.camera(i), pairs.target(i));
    }
  }

  private int part(NetworkView network, int camera, int target) {
    int view = network.seeing(camera);
    double half = network.zoom(camera, view).viewingAngle() / THIRDS / 2;
    double bearing = network.bearing(camera, target);
    int part = Math.abs(bearing) <= half ? 1 : bearing < 0 ? 0 : 2;
    boolean far = depth && network.distance(camera, target) > network.reach(camera, view) / 2;
    return 1 << (far ? THIRDS + part : part);
  }

  /** What a camera saw when all last looked. */
  int of(int camera) {
    return parts[camera];
  }

  /** What a camera sees now. */
  int now(NetworkView network, int camera) {
    int now = 0;
    for (int target = 0; target < network.targets(); target++) {
      now |= network.sees(camera, target) ? part(network, camera, target) : 0;
    }
    return now;
  }
}
