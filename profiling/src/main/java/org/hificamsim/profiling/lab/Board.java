package org.hificamsim.profiling.lab;

import org.opencv.core.Mat;
import org.opencv.core.Point;

/**
 * A flat textured surface in the room.
 *
 * @param texture the picture on the surface, over which it is stretched; square, BGR
 * @param round whether it is an ellipse instead of a rectangle
 * @param x the centre, metres to the right of the optical axis
 * @param y the centre, metres below the optical axis
 * @param distance the distance of the centre, in metres
 * @param pose the rotation
 */
record Board(
    Mat texture,
    boolean round,
    double width,
    double height,
    double x,
    double y,
    double distance,
    Pose pose) {
  /** Rotations about the vertical, the horizontal and the optical axis, in radians. */
  record Pose(double yaw, double pitch, double roll) {
    static final Pose FRONTAL = new Pose(0, 0, 0);
  }

  /**
   * Returns the canvas positions of the corners: top left, top right, bottom right, bottom left.
   */
  Point[] corners(Pinhole camera) {
    return new Point[] {
      corner(camera, -1, -1), corner(camera, 1, -1), corner(camera, 1, 1), corner(camera, -1, 1)
    };
  }

  private Point corner(Pinhole camera, int right, int down) {
    double u = right * width / 2;
    double v = down * height / 2;
    double cosRoll = StrictMath.cos(pose.roll());
    double sinRoll = StrictMath.sin(pose.roll());
    double rolledX = u * cosRoll - v * sinRoll;
    double rolledY = u * sinRoll + v * cosRoll;
    double cosPitch = StrictMath.cos(pose.pitch());
    double depth = rolledY * StrictMath.sin(pose.pitch());
    double yawedX = rolledX * StrictMath.cos(pose.yaw()) + depth * StrictMath.sin(pose.yaw());
    double yawedDepth = depth * StrictMath.cos(pose.yaw()) - rolledX * StrictMath.sin(pose.yaw());
    return camera.project(x + yawedX, y + rolledY * cosPitch, distance + yawedDepth);
  }
}
