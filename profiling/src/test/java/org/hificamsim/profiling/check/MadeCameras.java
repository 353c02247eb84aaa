package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.profiling.check.Calibration.Lens;
import org.hificamsim.profiling.check.Calibration.Size;

/** Synthetic cameras with known parameters. */
final class MadeCameras {
  static final Size PICTURE = new Size(768, 576);

  /** A lens without distortion for such a picture. */
  static final Lens LENS = bent(0);

  private MadeCameras() {}

  /**
   * A camera above the origin that looks north, along y.
   *
   * @param height the height in metres
   * @param tilt downwards, in degrees
   */
  static Calibration at(double height, double tilt, Lens lens) {
    double rx = Math.toRadians(90 + tilt);
    Vector3D shift = new Vector3D(0, height * Math.sin(rx), -height * Math.cos(rx));
    return Calibration.tsai(new Vector3D(rx, 0, 0), shift, lens, PICTURE);
  }

  /** Returns the same lens with distortion. */
  static Lens bent(double kappa1) {
    return new Lens(6, kappa1, 0.01, 0.012, 1.25, 384, 288);
  }

  /** Returns the matrix of such a camera for a world whose unit has this many metres. */
  static double[] matrix(double height, double tilt, double metres, double scale) {
    double[] p = new double[12];
    Vector3D shift = homogeneous(height, tilt, Vector3D.ZERO);
    Vector3D[] axes = {Vector3D.PLUS_I, Vector3D.PLUS_J, Vector3D.PLUS_K, Vector3D.ZERO};
    for (int column = 0; column < 4; column++) {
      Vector3D moved = homogeneous(height, tilt, axes[column].scalarMultiply(metres));
      Vector3D entry = column < 3 ? moved.subtract(shift) : shift;
      p[column] = scale * entry.getX();
      p[4 + column] = scale * entry.getY();
      p[8 + column] = scale * entry.getZ();
    }
    return p;
  }

  /** Returns (u w, v w, w) of a point by the pinhole formula. */
  private static Vector3D homogeneous(double height, double tilt, Vector3D point) {
    double down = Math.toRadians(tilt);
    double above = point.getZ() - height;
    double away = point.getY() * Math.cos(down) - above * Math.sin(down);
    double below = -point.getY() * Math.sin(down) - above * Math.cos(down);
    return new Vector3D(
        6 * 1.25 / 0.01 * point.getX() + 384 * away, 6 / 0.012 * below + 288 * away, away);
  }
}
