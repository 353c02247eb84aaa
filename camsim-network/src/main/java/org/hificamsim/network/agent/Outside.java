package org.hificamsim.network.agent;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;

/**
 * Which places are surely out of a camera's reach or angle: most pairs of a camera and a target are
 * told apart so, without the arc cosine of CamSim's own test, a native call.
 */
final class Outside {
  /** Far more than what rounding does to a cosine or a squared distance. */
  private static final double MARGIN = 1e-9;

  private Pose pose;
  private ZoomLevel zoom;
  private double squaredReach;
  private double cosine;

  /** Places from now on are seen from here. */
  void of(Pose newPose, ZoomLevel newZoom) {
    pose = newPose;
    if (!newZoom.equals(zoom)) {
      zoom = newZoom;
      squaredReach = zoom.radius() * zoom.radius() * (1 + MARGIN);
      cosine = zoom.allRound() ? -2 : Math.cos(zoom.viewingAngle() / 2) - MARGIN;
    }
  }

  /** Whether a place is surely not seen. */
  boolean has(double x, double y) {
    return pose.squaredDistance(x, y) > squaredReach || !pose.isInCone(cosine, x, y);
  }
}
