package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.engine.LateDetections;
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
 * The targets that each camera saw at its last look, with their confidences (behaviour 6.1 and
 * 6.2), in the order in which they became visible to the camera.
 */
public final class Sightings {
  /**
   * The number of pairs of cameras and targets below which looking at every pair is faster than a
   * grid.
   */
  private static final long MIN_PAIRS = 4_000;

  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final boolean open;
  private final Visibility visibility;
  private final PointGrid grid;

  /** The confidence by camera and target. */
  private final double[][] confidence;

  /** The visible targets of each camera, in the order in which they became visible. */
  private final int[][] visible;

  private final int[] visibleCounts;

  /** The sight that each camera last looked through; null after a change of any view. */
  private final LevelSight[] lastSights;

  private int viewRevision;

  /** The detections that come a step late, since the last look. */
  private LateDetections late;

  private final int[] foundTargets;
  private final double[] foundConfidences;
  private final long[] nearPoints;
  private final boolean[] isKept;

  /** Creates the sightings of a world's cameras, none at first. */
  public Sightings(World world, Visibility visibility) {
    cameras = world.cameras();
    targets = world.targets();
    lines = world.sightLines();
    open = lines.open();
    grid = createGrid(world);
    this.visibility = visibility;
    confidence = new double[cameras.count()][targets.count()];
    visible = new int[cameras.count()][targets.count()];
    visibleCounts = new int[cameras.count()];
    isKept = new boolean[targets.count()];
    lastSights = new LevelSight[cameras.count()];
    foundTargets = new int[targets.count()];
    foundConfidences = new double[targets.count()];
    nearPoints = new long[targets.count() + 1];
  }

  /** Creates a grid for all targets, whose cells are about as wide as cameras reach. */
  private PointGrid createGrid(World world) {
    int targetCount = targets.count();
    if ((long) cameras.count() * targetCount < MIN_PAIRS) {
      return PointGrid.single(targetCount);
    }
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      sum += cameras.zoom(camera, cameras.view(camera)).radius();
    }
    Field field = world.scenario().field();
    return PointGrid.over(
        field.minX(),
        field.minY(),
        field.width(),
        field.height(),
        sum / cameras.count(),
        targetCount);
  }

  /** Sorts the present targets into the grid; a target at NaN is left out. */
  private void fillGrid() {
    grid.clear();
    for (int target = 0; target < targets.count(); target++) {
      double x = targets.x(target);
      double y = targets.y(target);
      if (targets.present(target) && !Double.isNaN(x) && !Double.isNaN(y)) {
        grid.add(target, x, y);
      }
    }
    grid.sort();
  }

  /**
   * Lets every online camera look at every present target.
   *
   * @param step the current step
   * @param detected for each camera, receives the number of targets that it sees, 0 while offline
   * @param coverage for each target, receives the number of cameras that see it
   * @param newLate what cameras know a step late
   */
  public void look(long step, int[] detected, int[] coverage, LateDetections newLate) {
    late = newLate;
    fillGrid();
    forgetChangedSights();
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < detected.length; camera++) {
      detected[camera] = cameras.online(camera) ? look(step, camera) : 0;
      for (int i = 0; i < detected[camera]; i++) {
        coverage[foundTargets[i]]++;
      }
    }
  }

  private void forgetChangedSights() {
    if (viewRevision != cameras.viewRevision()) {
      viewRevision = cameras.viewRevision();
      Arrays.fill(lastSights, null);
    }
  }

  private int look(long step, int camera) {
    clearConfidences(camera);
    int view = cameras.seeing(camera);
    int count =
        view == Cameras.NO_VIEW
            ? 0
            : findVisible(step, camera, cameras.pose(camera, view), cameras.zoom(camera, view));
    int known = late.isLimited() && view != Cameras.NO_VIEW ? process(camera, count) : count;
    updateVisible(camera, known);
    return known;
  }

  /** Reduces the targets found to those that the camera can process; returns their number. */
  private int process(int camera, int count) {
    for (int i = 0; i < count; i++) {
      foundConfidences[i] = confidence[camera][foundTargets[i]];
      confidence[camera][foundTargets[i]] = 0;
    }
    int known = late.process(camera, foundTargets, foundConfidences, count);
    for (int i = 0; i < known; i++) {
      confidence[camera][foundTargets[i]] = foundConfidences[i];
    }
    Arrays.sort(foundTargets, 0, known);
    return known;
  }

  /**
   * Keeps the order of targets that are still visible, and appends the new ones by their number.
   */
  private void updateVisible(int camera, int found) {
    if (found == 0 && visibleCounts[camera] == 0) {
      return;
    }
    int[] order = visible[camera];
    int count = 0;
    for (int i = 0; i < visibleCounts[camera]; i++) {
      if (sees(camera, order[i])) {
        isKept[order[i]] = true;
        order[count++] = order[i];
      }
    }
    for (int i = 0; i < found; i++) {
      if (!isKept[foundTargets[i]]) {
        order[count++] = foundTargets[i];
      }
    }
    for (int i = 0; i < count; i++) {
      isKept[order[i]] = false;
    }
    visibleCounts[camera] = count;
  }

  /** Finds the targets that a camera sees, and returns their number. */
  private int findVisible(long step, int camera, Pose pose, ZoomLevel zoom) {
    if (grid.cells() == 1) {
      return findVisible(step, camera, pose, zoom, 0, grid.count(), 0);
    }
    double reach = Visibility.roundedUp(zoom.radius());
    int left = grid.column(pose.x() - reach);
    int right = grid.column(pose.x() + reach);
    int top = grid.row(pose.y() + reach);
    int count = 0;
    for (int row = grid.row(pose.y() - reach); row <= top; row++) {
      int start = grid.start(row, left);
      count = findVisible(step, camera, pose, zoom, start, grid.end(row, right), count);
    }
    Arrays.sort(foundTargets, 0, count);
    return count;
  }

  private int findVisible(
      long step, int camera, Pose pose, ZoomLevel zoom, int start, int end, int before) {
    double reach = Visibility.roundedUp(zoom.radius());
    int near = grid.findNear(pose.x(), pose.y(), reach * reach, start, end, nearPoints, 0);
    int count = before;
    LevelSight sight = null;
    for (int k = 0; k < near; k++) {
      int i = (int) nearPoints[k];
      int target = grid.point(i);
      if (sight == null || sight.body().size() != targets.size(target)) {
        sight = sight(camera, zoom, targets.size(target));
      }
      if (sight.isInView(pose, grid.x(i), grid.y(i))) {
        double luck = visibility.luck(step, camera, target);
        double transmittance = open ? 1 : lines.transmittance(camera, target);
        double newConfidence =
            sight.confidenceInView(pose, grid.x(i), grid.y(i), luck, transmittance);
        confidence[camera][target] = newConfidence;
        foundTargets[count] = target;
        count += newConfidence > 0 ? 1 : 0;
      }
    }
    return count;
  }

  /** Returns the sight of a zoom level and target size, which is usually the camera's last one. */
  private LevelSight sight(int camera, ZoomLevel zoom, double size) {
    LevelSight last = lastSights[camera];
    if (last == null || last.body().size() != size) {
      lastSights[camera] = visibility.at(zoom, size);
    }
    return lastSights[camera];
  }

  /** Resets the confidences of the targets that a camera saw, except for absent targets. */
  private void clearConfidences(int camera) {
    for (int i = 0; i < visibleCounts[camera]; i++) {
      int target = visible[camera][i];
      if (targets.present(target)) {
        confidence[camera][target] = 0;
      }
    }
  }

  /** Removes a target from what a camera sees, until its next look. */
  public void forget(int camera, int target) {
    confidence[camera][target] = 0;
    updateVisible(camera, 0);
  }

  /** The confidence with which the camera sees the target; 0 if it does not see it. */
  public double confidence(int camera, int target) {
    return confidence[camera][target];
  }

  /** Returns whether the camera sees the target. */
  public boolean sees(int camera, int target) {
    return confidence[camera][target] > 0;
  }

  /** The number of targets that the camera sees. */
  public int visibleCount(int camera) {
    return visibleCounts[camera];
  }

  /** Returns a visible target by its index in the order of appearance. */
  int visible(int camera, int index) {
    return visible[camera][index];
  }
}
