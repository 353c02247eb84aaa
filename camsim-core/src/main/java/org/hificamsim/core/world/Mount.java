package org.hificamsim.core.world;

import java.util.Arrays;
import java.util.function.ToIntFunction;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;

/** A camera's pose and views. It is immutable, so that worlds can share it. */
final class Mount {
  /** The position of the camera and the heading at which it is mounted. */
  final Pose pose;

  final ViewSet set;

  /** The zoom level of each view. */
  final ZoomLevel[] zooms;

  /** The number that equal zoom levels share, by view. */
  final int[] zoomNumbers;

  /** The position of the camera and the direction in which it looks, by view. */
  final Pose[] poses;

  /**
   * @param number gives a zoom level its number
   */
  Mount(Pose pose, ViewSet set, ToIntFunction<ZoomLevel> number) {
    this(pose, set, new ZoomLevel[set.count()], new int[set.count()]);
    int viewsPerPan = set.tilts().size() * set.zooms().size();
    for (int view = 0; view < zooms.length; view++) {
      zooms[view] = view < viewsPerPan ? set.zoom(view) : zooms[view - viewsPerPan];
      zoomNumbers[view] =
          view < viewsPerPan ? number.applyAsInt(zooms[view]) : zoomNumbers[view - viewsPerPan];
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

  /** The same camera at another pose. */
  Mount withPose(Pose other) {
    return new Mount(other, set, zooms, zoomNumbers);
  }
}
