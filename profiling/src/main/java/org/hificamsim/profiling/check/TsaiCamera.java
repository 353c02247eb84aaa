package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.RotationOrder;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * A camera calibrated by Tsai's method (R. Tsai, IEEE J. Robotics and Automation 3(4), 1987) with
 * one coefficient of radial distortion.
 *
 * @param view what turns and shifts the world before the camera
 * @param lens what brings it into the picture
 */
record TsaiCamera(Extrinsic view, Intrinsic lens) implements Calibration {
  /**
   * Where the camera is: x before it = R x + T, with R = Rz Ry Rx.
   *
   * @param rx radians
   * @param ry radians
   * @param rz radians
   * @param shift T, metres
   */
  record Extrinsic(double rx, double ry, double rz, Vector3D shift) {
    private Rotation rotation() {
      return new Rotation(RotationOrder.ZYX, RotationConvention.VECTOR_OPERATOR, rz, ry, rx);
    }

    Vector3D before(Vector3D world) {
      return rotation().applyTo(world).add(shift);
    }

    /** The direction in the world of one before the camera. */
    Vector3D turnedBack(Vector3D v) {
      return rotation().applyInverseTo(v);
    }
  }

  /**
   * The lens and the sensor.
   *
   * @param focal length, millimetres
   * @param kappa1 of radial distortion, per square millimetre: r (1 + kappa1 r^2) is where a
   *     pinhole would have had what the lens puts at r
   * @param dpx width of a pixel, millimetres
   * @param dpy height of a pixel, millimetres
   * @param sx what the width has to be multiplied by
   * @param cx the picture's centre, pixels
   * @param cy the picture's centre, pixels
   */
  record Intrinsic(
      double focal, double kappa1, double dpx, double dpy, double sx, double cx, double cy) {
    private static final int STEPS = 30; // Newton's method needs some five

    Pixel pixel(double x, double y) {
      double pinhole = focal * Math.hypot(x, y);
      double factor = pinhole == 0 ? 1 : distorted(pinhole) / pinhole;
      return new Pixel(cx + focal * x * factor * sx / dpx, cy + focal * y * factor / dpy);
    }

    /** The radius on the sensor of what a pinhole has at this one; NaN where the lens has none. */
    private double distorted(double pinhole) {
      double r = pinhole;
      for (int i = 0; i < STEPS; i++) {
        r -= (r * (1 + kappa1 * r * r) - pinhole) / (1 + 3 * kappa1 * r * r);
      }
      boolean found = Math.abs(r * (1 + kappa1 * r * r) - pinhole) <= 1e-9 * pinhole;
      return found && r >= 0 && 1 + 3 * kappa1 * r * r > 0 ? r : Double.NaN;
    }

    Vector3D ray(Pixel pixel) {
      double x = (pixel.u() - cx) * dpx / sx;
      double y = (pixel.v() - cy) * dpy;
      double factor = 1 + kappa1 * (x * x + y * y);
      return new Vector3D(x * factor / focal, y * factor / focal, 1);
    }
  }

  @Override
  public Pixel project(Vector3D point) {
    Vector3D before = view.before(point);
    return before.getZ() > 0
        ? lens.pixel(before.getX() / before.getZ(), before.getY() / before.getZ())
        : Pixel.NONE;
  }

  @Override
  public Vector3D ray(Pixel pixel) {
    return view.turnedBack(lens.ray(pixel));
  }

  @Override
  public Vector3D axis() {
    return view.turnedBack(Vector3D.PLUS_K);
  }

  @Override
  public Vector3D position() {
    return view.turnedBack(view.shift().negate());
  }

  @Override
  public double focalLength() {
    return lens.focal() / lens.dpy();
  }
}
