package org.hificamsim.core.engine;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/**
 * Chooses how targets are looked up: all in one list, or by the cells of a grid where that pays.
 */
final class GridChoice {
  /** Pairs of cameras and targets below which looking at all takes no longer. */
  private static final long MIN_PAIRS = 4_000;

  /** A cell's side, as a part of how far a camera detects. */
  private static final double SIDE = 1;

  /** With fewer cells most cameras would look at most targets anyway. */
  private static final int MIN_CELLS = 40;

  private GridChoice() {}

  /** An empty grid with room for all targets. */
  static PointGrid of(World world, Sight sight) {
    int targets = world.targets().count();
    if ((long) world.cameras().count() * targets < MIN_PAIRS) {
      return PointGrid.single(targets);
    }
    PointGrid grid = grid(world, SIDE * meanReach(world.cameras(), sight));
    return grid.cells() < MIN_CELLS ? PointGrid.single(targets) : grid;
  }

  /**
   * A grid over the field.
   *
   * @param side of its cells, metres
   */
  static PointGrid grid(World world, double side) {
    Field field = world.scenario().field();
    return PointGrid.over(
        field.minX(), field.minY(), field.width(), field.height(), side, world.targets().count());
  }

  private static double meanReach(Cameras cameras, Sight sight) {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      sum += reach(cameras, sight, camera);
    }
    return sum / cameras.count();
  }

  /** Of its widest view; through a lens between what its narrowest and its widest one detect. */
  private static double reach(Cameras cameras, Sight sight, int camera) {
    int last = cameras.views(camera) - 1;
    ZoomLevel zoom = cameras.zoom(camera, last);
    return zoom.hasLens()
        ? Math.sqrt(sight.reach(camera, 0) * sight.reach(camera, last))
        : zoom.radius();
  }
}
