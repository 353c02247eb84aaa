package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.world.Targets;

/** The different bodies of targets, the smallest first, by index. */
final class TargetBodies {
  private final Body[] bodies;

  /** The index of each target's body. */
  private final int[] indices;

  /**
   * @param flat whether no camera has a height
   */
  TargetBodies(Targets targets, boolean flat) {
    Body[] all = new Body[targets.count()];
    Arrays.setAll(all, flat ? target -> Body.flat(targets.seenSize(target)) : targets::body);
    bodies = Arrays.stream(all).sorted(Body.ORDER).distinct().toArray(Body[]::new);
    indices = new int[all.length];
    Arrays.setAll(indices, target -> Arrays.binarySearch(bodies, all[target], Body.ORDER));
  }

  int count() {
    return bodies.length;
  }

  Body body(int index) {
    return bodies[index];
  }

  int indexOf(int target) {
    return indices[target];
  }

  /** The index of the body whose size is nearest; -1 without targets. */
  int nearest(double size) {
    int nearest = bodies.length - 1;
    while (nearest > 0 && size - bodies[nearest - 1].size() <= bodies[nearest].size() - size) {
      nearest--;
    }
    return nearest;
  }
}
