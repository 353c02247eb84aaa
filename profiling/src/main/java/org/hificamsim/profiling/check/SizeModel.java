package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** How a size in the picture is predicted. */
enum SizeModel {
  /**
   * As the simulator has it: a flat world, in which a metre at a distance d has focal length / d
   * pixels.
   */
  FLAT {
    @Override
    Size size(Calibration camera, Vector3D foot, Size body) {
      double perMetre = camera.focalLength() / distance(camera, foot);
      return new Size(perMetre * body.width(), perMetre * body.height());
    }
  },

  /** The full calibration: height of the camera, tilt, distortion. */
  CALIBRATION {
    @Override
    Size size(Calibration camera, Vector3D foot, Size body) {
      Vector3D up = new Vector3D(0, 0, body.height());
      Vector3D aside = aside(camera, foot).scalarMultiply(body.width() / 2);
      Vector3D middle = foot.add(up.scalarMultiply(0.5));
      double left = camera.project(middle.add(aside)).u();
      double right = camera.project(middle.add(aside.negate())).u();
      double top = camera.project(foot.add(up)).v();
      return new Size(Math.abs(right - left), Math.abs(camera.project(foot).v() - top));
    }
  };

  /** The predicted box of a target that stands somewhere, in pixels. */
  abstract Size size(Calibration camera, Vector3D foot, Size body);

  /** Over the ground, metres. */
  static double distance(Calibration camera, Vector3D foot) {
    return Math.hypot(
        foot.getX() - camera.position().getX(), foot.getY() - camera.position().getY());
  }

  /** A metre on the ground, across the line from the camera. */
  private static Vector3D aside(Calibration camera, Vector3D foot) {
    double distance = distance(camera, foot);
    return new Vector3D(
        (camera.position().getY() - foot.getY()) / distance,
        (foot.getX() - camera.position().getX()) / distance,
        0);
  }
}
