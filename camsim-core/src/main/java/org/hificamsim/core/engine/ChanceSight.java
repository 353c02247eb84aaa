package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.ChanceTable;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The sight of models that depend on distance alone, and detect by chance. */
final class ChanceSight implements Sight {
  private final Cameras cameras;
  private final Targets targets;
  private final Visibility visibility;
  private final LevelRows rows;
  private ChanceTable[] tables = new ChanceTable[1];
  private long step;

  ChanceSight(World world, Visibility visibility) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.visibility = visibility;
    this.rows = new LevelRows(cameras, targets, this::newRow);
    rows.refresh();
  }

  private void newRow(ZoomLevel zoom, int row) {
    int entries = row + rows.sizes();
    if (entries > tables.length) {
      tables = Arrays.copyOf(tables, Math.max(entries, 2 * tables.length));
    }
    for (int size = 0; size < rows.sizes(); size++) {
      tables[row + size] = visibility.detection().chances(rows.size(size), zoom);
    }
  }

  @Override
  public void refresh(long newStep) {
    step = newStep;
    rows.refresh();
  }

  @Override
  public boolean detects(int camera, int level, int target) {
    double distance = distance(camera, target);
    return isInSight(camera, level, target, distance)
        && table(camera, level, target).detects(distance, visibility.luck(step, camera, target));
  }

  @Override
  public double chance(int camera, int level, int target) {
    double distance = distance(camera, target);
    return isInSight(camera, level, target, distance)
        ? table(camera, level, target).chance(distance)
        : 0;
  }

  private double distance(int camera, int target) {
    return cameras.pose(camera).distance(targets.x(target), targets.y(target));
  }

  private boolean isInSight(int camera, int level, int target, double distance) {
    ZoomLevel zoom = cameras.zoom(camera, level);
    return distance <= zoom.radius()
        && (rows.allRound(camera)
            || visibility.isInAngle(
                cameras.pose(camera), zoom, targets.x(target), targets.y(target)));
  }

  private ChanceTable table(int camera, int level, int target) {
    return tables[rows.entry(camera, level, target)];
  }

  /** Distance and luck are found once for all levels. */
  @Override
  public void mark(
      int camera, int levels, PointGrid grid, int from, int to, long[] masks, int words) {
    double widest = cameras.zoom(camera, 0).widestRadius();
    for (int i = from; i < to; i++) {
      int target = grid.point(i);
      double distance = cameras.pose(camera).distance(grid.x(i), grid.y(i));
      if (distance <= widest) {
        double luck = visibility.luck(step, camera, target);
        for (int level = 0; level < levels; level++) {
          if (isInSight(camera, level, target, distance)
              && table(camera, level, target).detects(distance, luck)) {
            masks[level * words + (target >> 6)] |= 1L << target;
          }
        }
      }
    }
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    return level == other;
  }

  @Override
  public double reach(int camera, int level) {
    return Sight.roundedUp(cameras.zoom(camera, level).radius());
  }
}
