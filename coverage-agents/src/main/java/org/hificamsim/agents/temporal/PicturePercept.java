package org.hificamsim.agents.temporal;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenTask;

/**
 * Where in its picture a camera sees targets: in the left, centre or right third of its opening
 * angle, and, where depth counts, near or far: up to half the {@linkplain NetworkView#reach reach}
 * of its view, or farther.
 */
final class PicturePercept {
  static final int THIRDS = 3;

  private static final SeenTask<PicturePercept> ADDING =
      (picture, target, distance, bearing) -> picture.add(distance, bearing);

  private final boolean depth;
  private int parts;
  private double third;
  private double near;

  PicturePercept(boolean depth) {
    this.depth = depth;
  }

  /** Looks at what the camera sees where all are now; a camera that moves blindly sees nothing. */
  int look(NetworkView network, int camera) {
    parts = 0;
    int view = network.seeing(camera);
    if (view >= 0) {
      third = network.zoom(camera, view).viewingAngle() / THIRDS;
      near = depth ? network.reach(camera, view) / 2 : 0;
      network.eachSeen(camera, this, ADDING);
    }
    return parts;
  }

  private void add(double distance, double bearing) {
    int part = Math.abs(bearing) <= third / 2 ? 1 : bearing < 0 ? 0 : 2;
    parts |= 1 << (depth && distance > near ? THIRDS + part : part);
  }

  /** What the last look saw: bit 0 for left, 1 for centre, 2 for right, then the same for far. */
  int parts() {
    return parts;
  }
}
