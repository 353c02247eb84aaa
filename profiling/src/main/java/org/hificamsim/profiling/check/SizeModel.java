package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.visibility.UprightPicture;
import org.hificamsim.profiling.check.Calibration.Size;

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

  /**
   * As the simulator has it where cameras have heights: a pinhole at the camera's height and tilt,
   * without roll, without distortion.
   */
  HEIGHTS {
    @Override
    Size size(Calibration camera, Vector3D foot, Size body) {
      Vector3D axis = camera.along();
      double along = Math.hypot(axis.getX(), axis.getY());
      double east = foot.getX() - camera.position().getX();
      double north = foot.getY() - camera.position().getY();
      double tilt = -Math.atan2(axis.getZ(), along);
      VerticalView view = new VerticalView(camera.position().getZ(), tilt, Double.NaN);
      double ahead = (east * axis.getX() + north * axis.getY()) / along;
      double right = (east * axis.getY() - north * axis.getX()) / along;
      double focal = camera.focalLength();
      return new Size(
          focal * UprightPicture.of(view, ahead, right, body.width(), body.height()).width(),
          focal * UprightPicture.of(view, ahead, right, 0, body.height()).height());
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
