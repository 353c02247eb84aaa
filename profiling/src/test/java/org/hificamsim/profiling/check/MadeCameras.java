package org.hificamsim.profiling.check;

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
    Vector place = new Vector(0, 0, height);
    Vector turned = new TsaiCamera.Extrinsic(rx, 0, 0, new Vector(0, 0, 0)).before(place);
    return new TsaiCamera(new TsaiCamera.Extrinsic(rx, 0, 0, turned.times(-1)), lens);
  }

  /** The same lens, bent. */
  static TsaiCamera.Intrinsic bent(double kappa1) {
    return new TsaiCamera.Intrinsic(6, kappa1, 0.01, 0.012, 1.25, 384, 288);
  }

  /** The matrix of a camera without distortion, whose world has so many metres to a unit. */
  static double[] matrix(TsaiCamera camera, double metres, double scale) {
    double[] p = new double[12];
    Vector[] units = {
      new Vector(0, 0, 0),
      new Vector(metres, 0, 0),
      new Vector(0, metres, 0),
      new Vector(0, 0, metres)
    };
    Vector shift = homogeneous(camera, units[0]);
    for (int column = 0; column < 3; column++) {
      Vector moved = homogeneous(camera, units[column + 1]).plus(shift.times(-1));
      p[column] = scale * moved.x();
      p[4 + column] = scale * moved.y();
      p[8 + column] = scale * moved.z();
    }
    p[3] = scale * shift.x();
    p[7] = scale * shift.y();
    p[11] = scale * shift.z();
    return p;
  }

  /** (u w, v w, w) of a point, by the pinhole's own formula. */
  private static Vector homogeneous(TsaiCamera camera, Vector point) {
    TsaiCamera.Intrinsic lens = camera.lens();
    Vector before = camera.view().before(point);
    return new Vector(
        lens.focal() * lens.sx() / lens.dpx() * before.x() + lens.cx() * before.z(),
        lens.focal() / lens.dpy() * before.y() + lens.cy() * before.z(),
        before.z());
  }
}
