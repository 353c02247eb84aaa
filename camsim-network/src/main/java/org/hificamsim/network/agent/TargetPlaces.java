package org.hificamsim.network.agent;

import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** Where the targets are, in the cells of a grid where that spares looking at most of them. */
final class TargetPlaces {
  /** Fewer pairs of cameras and targets are looked at one by one sooner. */
  private static final long MIN_PAIRS = 4_000;

  private TargetPlaces() {}

  /** A place for every target there will ever be, in cells as wide as cameras reach. */
  static PointGrid of(World world) {
    int all = world.targets().count();
    if ((long) world.cameras().count() * all < MIN_PAIRS) {
      return PointGrid.single(all);
    }
    Field field = world.scenario().field();
    double side = meanReach(world.cameras());
    return PointGrid.over(field.minX(), field.minY(), field.width(), field.height(), side, all);
  }

  private static double meanReach(Cameras cameras) {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      sum += cameras.zoom(camera, cameras.view(camera)).radius();
    }
    return sum / cameras.count();
  }

  /** Sorts the targets present; one whose place is no number is nowhere. */
  static void sort(PointGrid places, Targets targets) {
    places.clear();
    for (int target = 0; target < targets.count(); target++) {
      double x = targets.x(target);
      double y = targets.y(target);
      if (targets.present(target) && !Double.isNaN(x) && !Double.isNaN(y)) {
        places.add(target, x, y);
      }
    }
    places.sort();
  }
}
