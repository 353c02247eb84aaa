package org.hificamsim.agents.baseline;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenTask;

/** The nearest of the targets that a camera sees; of equally near ones the first. */
final class NearestTarget {
  private static final int NONE = -1;
  private static final SeenTask<NearestTarget> COMPARING = NearestTarget::compare;

  private int target;
  private double distance;
  private double bearing;

  /** Looks for it; false where the camera sees no target. */
  boolean find(NetworkView network, int camera) {
    target = NONE;
    network.eachSeen(camera, this, COMPARING);
    return target != NONE;
  }

  private void compare(int other, double otherDistance, double otherBearing) {
    boolean nearer = otherDistance < distance || (otherDistance == distance && other < target);
    if (target == NONE || nearer) {
      target = other;
      distance = otherDistance;
      bearing = otherBearing;
    }
  }

  /** Metres. */
  double distance() {
    return distance;
  }

  /** Radians off the axis of the camera's view, to the right. */
  double bearing() {
    return bearing;
  }
}
