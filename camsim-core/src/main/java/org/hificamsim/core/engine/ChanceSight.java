package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.ChanceTable;
import org.hificamsim.core.detection.ZoomLevel;
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
    ZoomLevel zoom = cameras.zoom(camera, level);
    double distance = cameras.pose(camera).distance(targets.x(target), targets.y(target));
    return distance <= zoom.radius()
        && (rows.allRound(camera) || isInAngle(camera, zoom, target))
        && tables[rows.entry(camera, level, target)].detects(
            distance, visibility.luck(step, camera, target));
  }

  private boolean isInAngle(int camera, ZoomLevel zoom, int target) {
    return visibility.isInAngle(cameras.pose(camera), zoom, targets.x(target), targets.y(target));
  }

  @Override
  public double chance(int camera, int level, int target) {
    return visibility.chance(
        cameras.pose(camera),
        cameras.zoom(camera, level),
        targets.x(target),
        targets.y(target),
        targets.size(target));
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
