package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** Cameras of our own making, whose every number is known. */
final class MadeCameras {
  /** Of a picture of 768 x 576 pixels. */
  static final TsaiCamera.Intrinsic LENS =
      new TsaiCamera.Intrinsic(6, 0, 0.01, 0.012, 1.25, 384, 288);

  private MadeCameras() {}

  /**
   * A camera above the origin that looks north, along y.
   *
   * @param height metres
   * @param tilt downwards, degrees
   */
  static TsaiCamera at(double height, double tilt, TsaiCamera.Intrinsic lens) {
    double rx = Math.toRadians(90 + tilt);
    Vector3D place = new Vector3D(0, 0, height);
    Vector3D turned = new TsaiCamera.Extrinsic(rx, 0, 0, new Vector3D(0, 0, 0)).before(place);
    return new TsaiCamera(new TsaiCamera.Extrinsic(rx, 0, 0, turned.negate()), lens);
  }

  /** The same lens, bent. */
  static TsaiCamera.Intrinsic bent(double kappa1) {
    return new TsaiCamera.Intrinsic(6, kappa1, 0.01, 0.012, 1.25, 384, 288);
  }

  /** The matrix of a camera without distortion, whose world has so many metres to a unit. */
  static double[] matrix(TsaiCamera camera, double metres, double scale) {
    double[] p = new double[12];
    Vector3D[] units = {
      new Vector3D(0, 0, 0),
      new Vector3D(metres, 0, 0),
      new Vector3D(0, metres, 0),
      new Vector3D(0, 0, metres)
    };
    Vector3D shift = homogeneous(camera, units[0]);
    for (int column = 0; column < 3; column++) {
      Vector3D moved = homogeneous(camera, units[column + 1]).add(shift.negate());
      p[column] = scale * moved.getX();
      p[4 + column] = scale * moved.getY();
      p[8 + column] = scale * moved.getZ();
    }
    p[3] = scale * shift.getX();
    p[7] = scale * shift.getY();
    p[11] = scale * shift.getZ();
    return p;
  }

  /** (u w, v w, w) of a point, by the pinhole's own formula. */
  private static Vector3D homogeneous(TsaiCamera camera, Vector3D point) {
    TsaiCamera.Intrinsic lens = camera.lens();
    Vector3D before = camera.view().before(point);
    return new Vector3D(
        lens.focal() * lens.sx() / lens.dpx() * before.getX() + lens.cx() * before.getZ(),
        lens.focal() / lens.dpy() * before.getY() + lens.cy() * before.getZ(),
        before.getZ());
  }
}
