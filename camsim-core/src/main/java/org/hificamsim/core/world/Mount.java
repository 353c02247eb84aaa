package org.hificamsim.core.world;

import java.util.Arrays;
import java.util.function.ToIntFunction;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;

/**
 * Where a camera stands, and how it looks in each of its views; never changes, so that worlds share
 * it.
 */
final class Mount {
  /** Where the camera stands and which way it is mounted. */
  final Pose pose;

  final ViewSet set;

  /** By view. */
  final ZoomLevel[] zooms;

  /** By view: a number that equal zoom levels have in common. */
  final int[] zoomNumbers;

  /** By view: where the camera stands and which way it looks. */
  final Pose[] poses;

  /**
   * @param number of a zoom level
   */
  Mount(Pose pose, ViewSet set, ToIntFunction<ZoomLevel> number) {
    this(pose, set, new ZoomLevel[set.count()], new int[set.count()]);
    int each = set.tilts().size() * set.zooms().size(); // the same at each pan angle
    for (int view = 0; view < zooms.length; view++) {
      zooms[view] = view < each ? set.zoom(view) : zooms[view - each];
      zoomNumbers[view] = view < each ? number.applyAsInt(zooms[view]) : zoomNumbers[view - each];
    }
  }

  private Mount(Pose pose, ViewSet set, ZoomLevel[] zooms, int[] zoomNumbers) {
    this.pose = pose;
    this.set = set;
    this.zooms = zooms;
    this.zoomNumbers = zoomNumbers;
    Pose[] byPan = new Pose[set.pans().size()];
    Arrays.setAll(byPan, pan -> pose.turned(set.pans().get(pan)));
    poses = new Pose[set.count()];
    Arrays.setAll(poses, view -> byPan[set.panOf(view)]);
  }

  /** The same camera elsewhere. */
  Mount at(Pose other) {
    return new Mount(other, set, zooms, zoomNumbers);
  }
}
