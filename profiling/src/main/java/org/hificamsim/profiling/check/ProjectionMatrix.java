package org.hificamsim.profiling.check;

import org.hificamsim.core.InputException;

/**
 * A camera as a matrix of three rows and four columns: (u w, v w, w) = P (x, y, z, 1). Hartley and
 * Zisserman, Multiple View Geometry (2004), 6.2: the left three columns are K R; the rows' third is
 * the view's axis.
 */
final class ProjectionMatrix implements Calibration {
  private static final double SINGULAR = 1e-12;

  private final Vector across;
  private final Vector down;
  private final Vector along;
  private final Vector shift;
  private final Vector position;

  /**
   * @param p the matrix, row by row, in any scale; 12 numbers
   * @param metres of a unit of its world
   * @throws InputException when it is no camera's
   */
  ProjectionMatrix(double[] p, double metres) {
    Vector third = new Vector(p[8], p[9], p[10]);
    double determinant =
        new Vector(p[0], p[1], p[2]).dot(new Vector(p[4], p[5], p[6]).cross(third));
    double size = third.length() * Math.signum(determinant);
    if (!(Math.abs(determinant) > SINGULAR * Math.pow(third.length(), 3))) {
      throw new InputException(
          "the matrix is not a camera's: the determinant of its left three columns is "
              + determinant
              + ", expected another than 0");
    }
    across = new Vector(p[0], p[1], p[2]).times(1 / size);
    down = new Vector(p[4], p[5], p[6]).times(1 / size);
    along = third.times(1 / size);
    shift = new Vector(p[3], p[7], p[11]).times(metres / size);
    position = solve(shift.times(-1));
  }

  /** The v for which the left three columns times v are a vector (Cramer's rule). */
  private Vector solve(Vector right) {
    double determinant = across.dot(down.cross(along));
    return down.cross(along)
        .times(right.x())
        .plus(along.cross(across).times(right.y()))
        .plus(across.cross(down).times(right.z()))
        .times(1 / determinant);
  }

  @Override
  public Pixel project(Vector point) {
    double w = along.dot(point) + shift.z();
    return w > 0
        ? new Pixel((across.dot(point) + shift.x()) / w, (down.dot(point) + shift.y()) / w)
        : Pixel.NONE;
  }

  @Override
  public Vector ray(Pixel pixel) {
    return solve(new Vector(pixel.u(), pixel.v(), 1));
  }

  @Override
  public Vector position() {
    return position;
  }

  /** With |third row| = 1 it is |second row x third row|, whatever the principal point. */
  @Override
  public double focalLength() {
    return down.cross(along).length();
  }
}
