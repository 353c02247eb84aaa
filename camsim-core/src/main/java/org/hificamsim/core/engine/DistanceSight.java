package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * The sight of models that depend on distance alone: the model is asked once per zoom level and
 * target size, and observing is a test of the squared distance.
 *
 * <p>Reaches are kept in {@linkplain ViewRows rows}. Nearly all are a single interval, held in two
 * flat arrays; the others are looked up in full. Where there is one size, the interval begins at 0
 * and nothing stands in between, what is seen is a disc: see {@link WholeDiscs}.
 */
final class DistanceSight implements Sight {
  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final boolean open;
  private final Visibility visibility;
  private final ViewRows rows;
  private final ValueTables values;
  private final WholeDiscs discs;
  private DetectedDistances[] reach = new DetectedDistances[1];
  private double[] from = new double[1];
  private double[] to = new double[1];
  private boolean[] single = new boolean[1];

  DistanceSight(World world, Visibility visibility) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.open = lines.open();
    this.visibility = visibility;
    this.values = new ValueTables(visibility.detection());
    this.rows = new ViewRows(cameras, targets, this::newRow);
    this.discs = new WholeDiscs(cameras, rows);
    rows.refresh();
  }

  @Override
  public void refresh(long step) {
    rows.refresh();
  }

  private void newRow(ZoomLevel zoom, int row) {
    makeRoom(row + rows.sizes());
    values.add(zoom, row, rows.sizes());
    for (int size = 0; size < rows.sizes(); size++) {
      fill(row + size, visibility.detection().distances(rows.size(size), zoom));
    }
    boolean whole = open && zoom.allRound() && rows.sizes() == 1 && single[row] && from[row] == 0;
    discs.set(row, whole ? Math.nextUp(to[row]) : Double.NaN);
  }

  private void makeRoom(int entries) {
    if (entries > reach.length) {
      int length = Math.max(entries, 2 * reach.length);
      reach = Arrays.copyOf(reach, length);
      from = Arrays.copyOf(from, length);
      to = Arrays.copyOf(to, length);
      single = Arrays.copyOf(single, length);
    }
  }

  private void fill(int at, DetectedDistances set) {
    reach[at] = set;
    single[at] = set.intervals() == 1;
    from[at] = set.intervals() == 0 ? Double.POSITIVE_INFINITY : set.from(0);
    to[at] = set.intervals() == 0 ? -1 : set.to(set.intervals() - 1);
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    double squared = cameras.pose(camera).squaredDistance(targets.x(target), targets.y(target));
    return isInView(camera, view, target, squared)
        && (open || passes(camera, view, target, lines.transmittance(camera, target)));
  }

  @Override
  public boolean detectsTurned(int camera, int view, int target) {
    double squared = cameras.pose(camera).squaredDistance(targets.x(target), targets.y(target));
    return isInReach(camera, view, target, squared)
        && (open || passes(camera, view, target, lines.transmittance(camera, target)));
  }

  /** Whether the target is near enough, and near enough to the axis, to be detected in the open. */
  private boolean isInView(int camera, int view, int target, double squared) {
    return isInReach(camera, view, target, squared)
        && (rows.allRound(camera, view) || isInAngle(camera, view, target));
  }

  private boolean isInReach(int camera, int view, int target, double squared) {
    int at = rows.entry(camera, view, target);
    if (!(squared >= from[at] && squared <= to[at])) {
      return false;
    }
    return single[at] || reach[at].contains(squared);
  }

  private boolean isInAngle(int camera, int view, int target) {
    return visibility.isInAngle(
        cameras.pose(camera, view),
        cameras.zoom(camera, view),
        rows.cosine(camera, view),
        targets.x(target),
        targets.y(target));
  }

  /** Whether enough of a target that is in view gets through. */
  private boolean passes(int camera, int view, int target, double transmittance) {
    if (transmittance == 0 || transmittance == 1) {
      return transmittance == 1;
    }
    double distance = cameras.pose(camera).distance(targets.x(target), targets.y(target));
    ZoomLevel zoom = cameras.zoom(camera, view);
    double value =
        visibility.detection().model().confidence(targets.size(target), distance, 0, zoom);
    return visibility.detection().detects(value, 0, transmittance);
  }

  @Override
  public double value(int camera, int view, int target, double distance) {
    return values.value(rows.entry(camera, view, target), targets.size(target), distance);
  }

  @Override
  public double reach(int camera, int view) {
    int row = rows.row(camera, view);
    double squared = to[row];
    for (int size = 1; size < rows.sizes(); size++) {
      squared = Math.max(squared, to[row + size]);
    }
    return squared < 0 ? 0 : Visibility.roundedUp(Math.sqrt(squared));
  }

  @Override
  public int look(int camera, int view, PointGrid grid, int begin, int end, int[] counts) {
    int row = rows.row(camera, view);
    return discs.has(row)
        ? discs.look(camera, row, grid, begin, end, counts)
        : Sight.super.look(camera, view, grid, begin, end, counts);
  }

  @Override
  public int find(
      int camera, int view, PointGrid grid, int begin, int end, long[] found, int count) {
    int row = rows.row(camera, view);
    return discs.has(row)
        ? discs.find(camera, row, grid, begin, end, found, count)
        : Sight.super.find(camera, view, grid, begin, end, found, count);
  }

  @Override
  public boolean lookAll(int begin, int end, PointGrid grid, int[] detected, int[] counts) {
    if (discs.isAll()) {
      discs.lookAll(begin, end, grid, detected, counts);
    }
    return discs.isAll();
  }

  @Override
  public int findAll(PointGrid grid, long[] found) {
    return discs.isAll() ? discs.findAll(grid, found) : -1;
  }

  /** What is in between is found once for all views, when a first one has the target in view. */
  @Override
  public void mark(
      int camera, int views, PointGrid grid, int begin, int end, long[] masks, int words) {
    if (discs.isAll()) {
      discs.mark(camera, views, grid, begin, end, masks, words);
      return;
    }
    Pose pose = cameras.pose(camera);
    for (int i = begin; i < end; i++) {
      double squared = pose.squaredDistance(grid.x(i), grid.y(i));
      int target = grid.point(i);
      double transmittance = open ? 1 : Double.NaN;
      for (int view = 0; view < views && transmittance != 0; view++) {
        if (isInView(camera, view, target, squared)) {
          transmittance =
              Double.isNaN(transmittance) ? lines.transmittance(camera, target) : transmittance;
          if (passes(camera, view, target, transmittance)) {
            masks[view * words + (target >> 6)] |= 1L << target;
          }
        }
      }
    }
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    if (lines.partial() || !includesAngle(camera, view, other)) {
      return view == other;
    }
    for (int size = 0; size < rows.sizes(); size++) {
      DetectedDistances mine = reach[rows.row(camera, view) + size];
      if (!mine.includes(reach[rows.row(camera, other) + size])) {
        return false;
      }
    }
    return true;
  }

  private boolean includesAngle(int camera, int view, int other) {
    return rows.allRound(camera, view)
        || (cameras.pan(camera, view) == cameras.pan(camera, other)
            && cameras.zoom(camera, view).viewingAngle()
                >= cameras.zoom(camera, other).viewingAngle());
  }
}
