package org.hificamsim.network.agent;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;

/**
 * Which places are surely out of a camera's reach or angle: most pairs of a camera and a target are
 * told apart so, without the arc cosine of CamSim's own test and without a root: a square keeps the
 * order where it keeps the sign.
 */
final class Outside {
  /** Far more than what rounding does to a cosine or a squared distance. */
  private static final double MARGIN = 1e-9;

  private Pose pose;
  private ZoomLevel zoom;
  private double squaredReach;
  private double signedSquare;

  /** Places from now on are seen from here. */
  void of(Pose newPose, ZoomLevel newZoom) {
    pose = newPose;
    if (!newZoom.equals(zoom)) {
      zoom = newZoom;
      squaredReach = zoom.radius() * zoom.radius() * (1 + MARGIN);
      double cosine = Math.cos(zoom.viewingAngle() / 2) - MARGIN;
      signedSquare = zoom.allRound() ? -2 : cosine * Math.abs(cosine);
    }
  }

  /**
   * Finds the places that are not surely outside, among some of a grid.
   *
   * @param found receives their numbers in the grid, in its order
   * @return how many
   */
  int findOthers(PointGrid places, int from, int to, int[] found) {
    double x = pose.x();
    double y = pose.y();
    double headingX = pose.headingX();
    double headingY = pose.headingY();
    int count = 0;
    for (int i = from; i < to; i++) {
      double dx = places.x(i) - x;
      double dy = places.y(i) - y;
      double squared = dx * dx + dy * dy;
      double along = dx * headingX + dy * headingY;
      found[count] = i;
      count += squared > squaredReach || along * Math.abs(along) < signedSquare * squared ? 0 : 1;
    }
    return count;
  }
}
