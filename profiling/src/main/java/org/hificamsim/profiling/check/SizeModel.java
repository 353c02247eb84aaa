package org.hificamsim.profiling.check;

/** How a size in the picture is predicted. */
enum SizeModel {
  /**
   * As the simulator has it: a flat world, in which a metre at a distance d has focal length / d
   * pixels.
   */
  FLAT {
    @Override
    Size size(Calibration camera, Vector foot, Body body) {
      double perMetre = camera.focalLength() / distance(camera, foot);
      return new Size(perMetre * body.width(), perMetre * body.height());
    }
  },

  /** The full calibration: height of the camera, tilt, distortion. */
  CALIBRATION {
    @Override
    Size size(Calibration camera, Vector foot, Body body) {
      Vector up = new Vector(0, 0, body.height());
      Vector aside = aside(camera, foot).times(body.width() / 2);
      Vector middle = foot.plus(up.times(0.5));
      double left = camera.project(middle.plus(aside)).u();
      double right = camera.project(middle.plus(aside.times(-1))).u();
      double top = camera.project(foot.plus(up)).v();
      return new Size(Math.abs(right - left), Math.abs(camera.project(foot).v() - top));
    }
  };

  /** The predicted box of a target that stands somewhere, in pixels. */
  abstract Size size(Calibration camera, Vector foot, Body body);

  /** Over the ground, metres. */
  static double distance(Calibration camera, Vector foot) {
    return Math.hypot(foot.x() - camera.position().x(), foot.y() - camera.position().y());
  }

  /** A metre on the ground, across the line from the camera. */
  private static Vector aside(Calibration camera, Vector foot) {
    double distance = distance(camera, foot);
    return new Vector(
        (camera.position().y() - foot.y()) / distance,
        (foot.x() - camera.position().x()) / distance,
        0);
  }
}
