package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * What each camera saw at its last look, and with what confidence (behaviour 6.1 and 6.2). The
 * targets that a camera sees are kept in the order in which they became visible to it.
 */
public final class Sightings {
  /** Fewer pairs of cameras and targets are looked at one by one sooner. */
  private static final long MIN_PAIRS = 4_000;

  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final Visibility visibility;
  private final PointGrid places;
  private final double[][] confidence; // by camera and target
  private final int[][] visible; // by camera, in order
  private final int[] visibleCount;
  private final LevelSight[] sights; // by camera
  private final int[] seen;
  private final boolean[] kept;

  /** What cameras will see, nothing so far. */
  public Sightings(World world, Visibility visibility) {
    cameras = world.cameras();
    targets = world.targets();
    lines = world.sightLines();
    places = places(world);
    this.visibility = visibility;
    confidence = new double[cameras.count()][targets.count()];
    visible = new int[cameras.count()][targets.count()];
    visibleCount = new int[cameras.count()];
    kept = new boolean[targets.count()];
    sights = new LevelSight[cameras.count()];
    seen = new int[targets.count()];
  }

  /** A place for every target there will ever be, in cells about as wide as cameras reach. */
  private PointGrid places(World world) {
    int all = targets.count();
    if ((long) cameras.count() * all < MIN_PAIRS) {
      return PointGrid.single(all);
    }
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      sum += cameras.zoom(camera, cameras.view(camera)).radius();
    }
    Field field = world.scenario().field();
    return PointGrid.over(
        field.minX(), field.minY(), field.width(), field.height(), sum / cameras.count(), all);
  }

  /** Sorts the targets present; one whose place is no number is nowhere. */
  private void locate() {
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

  /**
   * Every online camera looks at every target present.
   *
   * @param step that is under way
   * @param detected one entry per camera, receives how many targets it sees, 0 while offline
   * @param coverage one entry per target, receives how many cameras see it
   */
  public void look(long step, int[] detected, int[] coverage) {
    locate();
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < detected.length; camera++) {
      detected[camera] = cameras.online(camera) ? look(step, camera) : 0;
      for (int i = 0; i < detected[camera]; i++) {
        coverage[seen[i]]++;
      }
    }
  }

  private int look(long step, int camera) {
    doubt(camera);
    int view = cameras.seeing(camera);
    int count =
        view == Cameras.NO_VIEW
            ? 0
            : find(step, camera, cameras.pose(camera, view), cameras.zoom(camera, view));
    list(camera, count);
    return count;
  }

  /** Who is still visible keeps its place, who became visible comes last, in the targets' order. */
  private void list(int camera, int found) {
    int[] list = visible[camera];
    int count = 0;
    for (int i = 0; i < visibleCount[camera]; i++) {
      if (sees(camera, list[i])) {
        kept[list[i]] = true;
        list[count++] = list[i];
      }
    }
    for (int i = 0; i < found; i++) {
      if (!kept[seen[i]]) {
        list[count++] = seen[i];
      }
    }
    for (int i = 0; i < count; i++) {
      kept[list[i]] = false;
    }
    visibleCount[camera] = count;
  }

  /** Finds the targets that a camera sees; returns how many. */
  private int find(long step, int camera, Pose pose, ZoomLevel zoom) {
    if (places.cells() == 1) {
      return find(step, camera, pose, zoom, 0, places.count(), 0);
    }
    double reach = Visibility.roundedUp(zoom.radius());
    int left = places.column(pose.x() - reach);
    int right = places.column(pose.x() + reach);
    int top = places.row(pose.y() + reach);
    int count = 0;
    for (int row = places.row(pose.y() - reach); row <= top; row++) {
      int start = places.start(row, left);
      count = find(step, camera, pose, zoom, start, places.end(row, right), count);
    }
    Arrays.sort(seen, 0, count);
    return count;
  }

  private int find(
      long step, int camera, Pose pose, ZoomLevel zoom, int start, int end, int before) {
    int count = before;
    for (int i = start; i < end; i++) {
      int target = places.point(i);
      LevelSight sight = sight(camera, zoom, targets.size(target));
      if (sight.isInView(pose, places.x(i), places.y(i))) {
        double luck = visibility.luck(step, camera, target);
        double transmittance = lines.transmittance(camera, target);
        double sure = sight.confidenceInView(pose, places.x(i), places.y(i), luck, transmittance);
        confidence[camera][target] = sure;
        seen[count] = target;
        count += sure > 0 ? 1 : 0;
      }
    }
    return count;
  }

  /** Most often the one that the camera looked by before. */
  private LevelSight sight(int camera, ZoomLevel zoom, double size) {
    LevelSight last = sights[camera];
    if (last == null || !last.isOf(zoom, size)) {
      sights[camera] = visibility.at(zoom, size);
    }
    return sights[camera];
  }

  /** What a camera saw counts no longer; what is not there stays as it was. */
  private void doubt(int camera) {
    for (int i = 0; i < visibleCount[camera]; i++) {
      int target = visible[camera][i];
      if (targets.present(target)) {
        confidence[camera][target] = 0;
      }
    }
  }

  /** A camera loses sight of a target, whatever its next look brings. */
  public void forget(int camera, int target) {
    confidence[camera][target] = 0;
    list(camera, 0);
  }

  /** How sure the camera is of the target; 0 where it does not see it. */
  public double confidence(int camera, int target) {
    return confidence[camera][target];
  }

  /** Whether the camera sees the target. */
  public boolean sees(int camera, int target) {
    return confidence[camera][target] > 0;
  }

  /** How many targets the camera sees. */
  public int visible(int camera) {
    return visibleCount[camera];
  }

  /** One of these targets, by its place in their order. */
  int visible(int camera, int place) {
    return visible[camera][place];
  }
}
