package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.visibility.UprightPicture;
import org.hificamsim.profiling.check.Calibration.Size;

/** A rung of realism: a way to predict the size of a target in the picture. */
enum SizeModel {
  /** A flat world, as in the simulator: a metre at distance d has focal length / d pixels. */
  FLAT {
    @Override
    Size size(Calibration camera, Vector3D foot, Size body) {
      double pixelsPerMetre = camera.focalLength() / distance(camera, foot);
      return new Size(pixelsPerMetre * body.width(), pixelsPerMetre * body.height());
    }
  },

  /**
   * Cameras with heights, as in the simulator: a pinhole at the camera's height and tilt, without
   * roll or distortion.
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
      Vector3D sideways = sideways(camera, foot).scalarMultiply(body.width() / 2);
      Vector3D middle = foot.add(up.scalarMultiply(0.5));
      double left = camera.project(middle.add(sideways)).u();
      double right = camera.project(middle.add(sideways.negate())).u();
      double top = camera.project(foot.add(up)).v();
      return new Size(Math.abs(right - left), Math.abs(camera.project(foot).v() - top));
    }
  };

  /** Predicts the box of a target that stands at {@code foot}, in pixels. */
  abstract Size size(Calibration camera, Vector3D foot, Size body);

  /** Returns the distance between camera and target over the ground, in metres. */
  static double distance(Calibration camera, Vector3D foot) {
    return Math.hypot(
        foot.getX() - camera.position().getX(), foot.getY() - camera.position().getY());
  }

  /** Returns the unit vector on the ground that is perpendicular to the line from the camera. */
  private static Vector3D sideways(Calibration camera, Vector3D foot) {
    double distance = distance(camera, foot);
    return new Vector3D(
        (camera.position().getY() - foot.getY()) / distance,
        (foot.getX() - camera.position().getX()) / distance,
        0);
  }
}
