package org.hificamsim.profiling.check;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Optional;
import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.RotationOrder;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.MatrixFile;

/**
 * The calibration of a real camera, which maps points of the world to its picture. The world is in
 * metres; the ground is at z = 0 and z points upwards. Without distortion (u w, v w, w) = A (x, y,
 * z) + shift; Hartley and Zisserman, Multiple View Geometry (2004), 6.2: A is K R, and its last
 * row, of length 1, is the optical axis.
 *
 * @param across the first row of A
 * @param down the second row
 * @param along the third row: the direction that the camera looks in
 * @param lens the distortion of the lens
 * @param picture the size of the picture, in pixels
 */
public record Calibration(
    Vector3D across, Vector3D down, Vector3D along, Vector3D shift, Lens lens, Size picture) {
  private static final double SINGULAR = 1e-12;

  /**
   * The lens and the sensor by Tsai's method (R. Tsai, IEEE J. Robotics and Automation 3(4), 1987)
   * with one coefficient of radial distortion.
   *
   * @param focal the focal length, in millimetres
   * @param kappa1 the radial distortion, per square millimetre: what the lens shows at radius r, a
   *     pinhole would show at r (1 + kappa1 r^2)
   * @param dpx width of a pixel, in millimetres
   * @param dpy height of a pixel, in millimetres
   * @param sx the horizontal scale factor
   * @param cx the column of the picture's centre, in pixels
   * @param cy the row of the picture's centre, in pixels
   */
  record Lens(
      double focal, double kappa1, double dpx, double dpy, double sx, double cx, double cy) {
    private static final Lens STRAIGHT = new Lens(1, 0, 1, 1, 1, 0, 0);

    /** The greatest number of steps of Newton's method, which usually needs about five. */
    private static final int MAX_NEWTON_STEPS = 30;

    /** Returns where the lens shows what a pinhole shows at a pixel; NaN if it does not show it. */
    Pixel bent(Pixel pinhole) {
      double radius = Math.hypot(right(pinhole), below(pinhole));
      return moved(pinhole, radius == 0 ? 1 : distorted(radius) / radius);
    }

    /** Returns where a pinhole shows what the lens shows at a pixel. */
    Pixel straight(Pixel pixel) {
      double radius = Math.hypot(right(pixel), below(pixel));
      return moved(pixel, 1 + kappa1 * radius * radius);
    }

    private double right(Pixel pixel) {
      return (pixel.u() - cx) * dpx / sx;
    }

    private double below(Pixel pixel) {
      return (pixel.v() - cy) * dpy;
    }

    private Pixel moved(Pixel pixel, double factor) {
      return new Pixel(cx + (pixel.u() - cx) * factor, cy + (pixel.v() - cy) * factor);
    }

    /** Returns the radius at which the lens shows what a pinhole shows at this one; NaN if none. */
    private double distorted(double pinhole) {
      double r = pinhole;
      for (int i = 0; i < MAX_NEWTON_STEPS; i++) {
        r -= (r * (1 + kappa1 * r * r) - pinhole) / (1 + 3 * kappa1 * r * r);
      }
      boolean found = Math.abs(r * (1 + kappa1 * r * r) - pinhole) <= 1e-9 * pinhole;
      return found && r >= 0 && 1 + 3 * kappa1 * r * r > 0 ? r : Double.NaN;
    }
  }

  /**
   * A position in a picture.
   *
   * @param u pixels to the right of the picture's left edge
   * @param v pixels down from its upper edge
   */
  record Pixel(double u, double v) {
    /** The position of a point that the picture does not show. */
    private static final Pixel NONE = new Pixel(Double.NaN, Double.NaN);

    /** Returns the distance to another position, in pixels. */
    double distance(Pixel other) {
      return Math.hypot(u - other.u, v - other.v);
    }
  }

  /** Width and height: of a box or a picture in pixels, of a body in metres. */
  public record Size(double width, double height) {
    double area() {
      return width * height;
    }

    @Override
    public String toString() {
      return Math.round(width) + "x" + Math.round(height);
    }
  }

  /**
   * Reads a calibration: XML by Tsai's method, as the PETS recordings have it, or a matrix of three
   * rows and four columns.
   *
   * @param unit the unit of the calibration's world; by default millimetres for XML and metres for
   *     a matrix
   * @param givenSize the size of the picture; required for a matrix, which does not contain it
   * @throws InputException with line and column, when the file is wrong or incomplete
   */
  public static Calibration read(Path file, Optional<Unit> unit, Optional<Size> givenSize) {
    if (isXml(file)) {
      return new TsaiFile().read(file, unit.orElse(Unit.MM).metres(), givenSize);
    }
    double[] rows = MatrixFile.read(file, 3, 4, "three rows of four numbers");
    Size picture =
        givenSize.orElseThrow(
            () ->
                InputException.of(
                    "%s: a matrix does not say how large the picture is, expected %s",
                    file, setting("image", "WIDTHxHEIGHT")));
    try {
      return matrix(rows, unit.orElse(Unit.M).metres(), picture);
    } catch (InputException e) {
      throw new InputException(file + ": " + e.getMessage(), e);
    }
  }

  private static boolean isXml(Path file) {
    try (TextLines lines = TextLines.open(file)) {
      while (lines.next()) {
        if (!lines.text().isBlank()) {
          return lines.text().strip().replace("\uFEFF", "").startsWith("<");
        }
      }
      return false;
    }
  }

  /**
   * A camera without distortion.
   *
   * @param p the camera matrix, row by row, in any scale; 12 numbers
   * @param metres the length of a unit of its world, in metres
   * @throws InputException when the matrix is singular
   */
  static Calibration matrix(double[] p, double metres, Size picture) {
    Vector3D first = new Vector3D(p[0], p[1], p[2]);
    Vector3D second = new Vector3D(p[4], p[5], p[6]);
    Vector3D third = new Vector3D(p[8], p[9], p[10]);
    double determinant = first.dotProduct(second.crossProduct(third));
    if (!(Math.abs(determinant) > SINGULAR * Math.pow(third.getNorm(), 3))) {
      throw InputException.of(
          "the matrix is not a camera's: the determinant of its left three columns is"
              + " %s, expected another than 0",
          determinant);
    }
    double scale = 1 / (third.getNorm() * Math.signum(determinant));
    return new Calibration(
        first.scalarMultiply(scale),
        second.scalarMultiply(scale),
        third.scalarMultiply(scale),
        new Vector3D(p[3], p[7], p[11]).scalarMultiply(metres * scale),
        Lens.STRAIGHT,
        picture);
  }

  /**
   * Returns a camera by Tsai's method: its coordinates of x are R x + T, with R = Rz Ry Rx.
   *
   * @param angles rx, ry and rz, in radians
   * @param shift T, in metres
   */
  static Calibration tsai(Vector3D angles, Vector3D shift, Lens lens, Size picture) {
    double[][] r =
        new Rotation(
                RotationOrder.ZYX,
                RotationConvention.VECTOR_OPERATOR,
                angles.getZ(),
                angles.getY(),
                angles.getX())
            .getMatrix();
    double horizontalFocal = lens.focal() * lens.sx() / lens.dpx();
    double verticalFocal = lens.focal() / lens.dpy();
    Vector3D along = new Vector3D(r[2]);
    return new Calibration(
        new Vector3D(horizontalFocal, new Vector3D(r[0]), lens.cx(), along),
        new Vector3D(verticalFocal, new Vector3D(r[1]), lens.cy(), along),
        along,
        new Vector3D(
            horizontalFocal * shift.getX() + lens.cx() * shift.getZ(),
            verticalFocal * shift.getY() + lens.cy() * shift.getZ(),
            shift.getZ()),
        lens,
        picture);
  }

  /** Solves A v = right for v (Cramer's rule). */
  private Vector3D solve(Vector3D right) {
    double determinant = across.dotProduct(down.crossProduct(along));
    return down.crossProduct(along)
        .scalarMultiply(right.getX())
        .add(along.crossProduct(across).scalarMultiply(right.getY()))
        .add(across.crossProduct(down).scalarMultiply(right.getZ()))
        .scalarMultiply(1 / determinant);
  }

  /** Returns where a point is in the picture; NaN if it is behind the camera. */
  Pixel project(Vector3D point) {
    double w = along.dotProduct(point) + shift.getZ();
    return w > 0
        ? lens.bent(
            new Pixel(
                (across.dotProduct(point) + shift.getX()) / w,
                (down.dotProduct(point) + shift.getY()) / w))
        : Pixel.NONE;
  }

  /** Returns the position of the camera, in metres. */
  public Vector3D position() {
    return solve(shift.negate());
  }

  /** Returns the vertical focal length in pixels, which does not depend on the principal point. */
  public double focalLength() {
    return down.crossProduct(along).getNorm();
  }

  /**
   * Returns the point of the ground at a pixel, in metres; NaN above the horizon.
   *
   * @param u pixels to the right of the picture's left edge
   * @param v pixels down from its upper edge
   */
  public Vector3D ground(double u, double v) {
    return ground(new Pixel(u, v));
  }

  /** Returns the point of the ground at a pixel; NaN above the horizon. */
  Vector3D ground(Pixel pixel) {
    Pixel straight = lens.straight(pixel);
    Vector3D ray = solve(new Vector3D(straight.u(), straight.v(), 1));
    double times = -position().getZ() / ray.getZ();
    return times > 0 ? position().add(ray.scalarMultiply(times)) : Vector3D.NaN;
  }
}
