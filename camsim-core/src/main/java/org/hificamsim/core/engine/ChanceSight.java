package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.ChanceTable;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The sight of models that depend on distance alone, and detect by chance. */
final class ChanceSight implements Sight {
  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final boolean open;
  private final Visibility visibility;
  private final ViewRows rows;
  private final ValueTables values;
  private ChanceTable[] tables = new ChanceTable[1];
  private long step;

  ChanceSight(World world, Visibility visibility) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.open = lines.open();
    this.visibility = visibility;
    this.values = new ValueTables(visibility.detection());
    this.rows = new ViewRows(cameras, targets, this::newRow);
    rows.refresh();
  }

  private void newRow(ZoomLevel zoom, int row) {
    values.add(zoom, row, rows.sizes());
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
  public boolean detects(int camera, int view, int target) {
    double distance = distance(camera, target);
    return isInView(camera, view, target, distance) && isLucky(camera, view, target, distance);
  }

  @Override
  public boolean detectsTurned(int camera, int view, int target) {
    double distance = distance(camera, target);
    return distance <= cameras.zoom(camera, view).radius()
        && isLucky(camera, view, target, distance);
  }

  private boolean isLucky(int camera, int view, int target, double distance) {
    return table(camera, view, target)
        .detects(distance, visibility.luck(step, camera, target), through(camera, target));
  }

  @Override
  public double chance(int camera, int view, int target) {
    double distance = distance(camera, target);
    return isInView(camera, view, target, distance)
        ? through(camera, target) * table(camera, view, target).chance(distance)
        : 0;
  }

  @Override
  public double value(int camera, int view, int target) {
    double distance = distance(camera, target);
    return values.value(rows.entry(camera, view, target), targets.size(target), distance);
  }

  private double distance(int camera, int target) {
    return cameras.pose(camera).distance(targets.x(target), targets.y(target));
  }

  private boolean isInView(int camera, int view, int target, double distance) {
    ZoomLevel zoom = cameras.zoom(camera, view);
    return distance <= zoom.radius()
        && (rows.allRound(camera, view)
            || visibility.isInAngle(
                cameras.pose(camera, view),
                zoom,
                rows.cosine(camera, view),
                targets.x(target),
                targets.y(target)));
  }

  private double through(int camera, int target) {
    return open ? 1 : lines.transmittance(camera, target);
  }

  private ChanceTable table(int camera, int view, int target) {
    return tables[rows.entry(camera, view, target)];
  }

  /** Distance, luck and what gets through are found once for all views. */
  @Override
  public void mark(
      int camera, int views, PointGrid grid, int from, int to, long[] masks, int words) {
    double widest = cameras.zoom(camera, 0).widestRadius();
    for (int i = from; i < to; i++) {
      int target = grid.point(i);
      double distance = cameras.pose(camera).distance(grid.x(i), grid.y(i));
      double through = distance <= widest ? through(camera, target) : 0;
      if (through > 0) {
        double luck = visibility.luck(step, camera, target);
        for (int view = 0; view < views; view++) {
          if (isInView(camera, view, target, distance)
              && table(camera, view, target).detects(distance, luck, through)) {
            masks[view * words + (target >> 6)] |= 1L << target;
          }
        }
      }
    }
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    return view == other;
  }

  @Override
  public double reach(int camera, int view) {
    return Visibility.roundedUp(cameras.zoom(camera, view).radius());
  }
}
