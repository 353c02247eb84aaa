package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;

/**
 * A camera as a matrix of three rows and four columns: (u w, v w, w) = P (x, y, z, 1). Hartley and
 * Zisserman, Multiple View Geometry (2004), 6.2: the left three columns are K R; the rows' third is
 * the view's axis.
 */
final class ProjectionMatrix implements Calibration {
  private static final double SINGULAR = 1e-12;

  private final Vector3D across;
  private final Vector3D down;
  private final Vector3D along;
  private final Vector3D shift;
  private final Vector3D position;

  /**
   * @param p the matrix, row by row, in any scale; 12 numbers
   * @param metres of a unit of its world
   * @throws InputException when it is no camera's
   */
  ProjectionMatrix(double[] p, double metres) {
    Vector3D third = new Vector3D(p[8], p[9], p[10]);
    double determinant =
        new Vector3D(p[0], p[1], p[2])
            .dotProduct(new Vector3D(p[4], p[5], p[6]).crossProduct(third));
    double size = third.getNorm() * Math.signum(determinant);
    if (!(Math.abs(determinant) > SINGULAR * Math.pow(third.getNorm(), 3))) {
      throw InputException.of(
          "the matrix is not a camera's: the determinant of its left three columns is"
              + " %s, expected another than 0",
          determinant);
    }
    across = new Vector3D(p[0], p[1], p[2]).scalarMultiply(1 / size);
    down = new Vector3D(p[4], p[5], p[6]).scalarMultiply(1 / size);
    along = third.scalarMultiply(1 / size);
    shift = new Vector3D(p[3], p[7], p[11]).scalarMultiply(metres / size);
    position = solve(shift.negate());
  }

  /** The v for which the left three columns times v are a vector (Cramer's rule). */
  private Vector3D solve(Vector3D right) {
    double determinant = across.dotProduct(down.crossProduct(along));
    return down.crossProduct(along)
        .scalarMultiply(right.getX())
        .add(along.crossProduct(across).scalarMultiply(right.getY()))
        .add(across.crossProduct(down).scalarMultiply(right.getZ()))
        .scalarMultiply(1 / determinant);
  }

  @Override
  public Pixel project(Vector3D point) {
    double w = along.dotProduct(point) + shift.getZ();
    return w > 0
        ? new Pixel(
            (across.dotProduct(point) + shift.getX()) / w,
            (down.dotProduct(point) + shift.getY()) / w)
        : Pixel.NONE;
  }

  @Override
  public Vector3D ray(Pixel pixel) {
    return solve(new Vector3D(pixel.u(), pixel.v(), 1));
  }

  @Override
  public Vector3D axis() {
    return along;
  }

  @Override
  public Vector3D position() {
    return position;
  }

  /** With |third row| = 1 it is |second row x third row|, whatever the principal point. */
  @Override
  public double focalLength() {
    return down.crossProduct(along).getNorm();
  }
}
