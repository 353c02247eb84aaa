package org.hificamsim.network.agent;

import org.hificamsim.core.detection.ZoomLevel;
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

  /** Whether a place is surely not seen. */
  boolean has(double x, double y) {
    double dx = x - pose.x();
    double dy = y - pose.y();
    double squared = dx * dx + dy * dy;
    double along = dx * pose.headingX() + dy * pose.headingY();
    return squared > squaredReach || along * Math.abs(along) < signedSquare * squared;
  }
}
