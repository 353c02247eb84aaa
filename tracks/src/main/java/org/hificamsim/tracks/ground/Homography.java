package org.hificamsim.tracks.ground;

import java.nio.file.Path;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.tracks.format.Sample;

/**
 * Takes pixels (to the right, down) to metres on the ground: (x w, y w, w) = H (u, v, 1). A box as
 * wide as it is in the picture stands on the ground where its lower edge is; its height is to its
 * width as in the picture.
 */
public final class Homography implements Ground {
  private static final int SIZE = 3;

  private final double[] h;

  private Homography(double[] h) {
    this.h = h;
  }

  /**
   * Reads three rows of three numbers between blanks.
   *
   * @throws org.hificamsim.core.InputException with the place, when it has others
   */
  public static Homography read(Path file) {
    double[] h = new double[SIZE * SIZE];
    int count = 0;
    try (TextLines lines = TextLines.open(file)) {
      while (lines.nextFields()) {
        count = row(lines, h, count);
      }
      if (count < h.length) {
        throw lines.place().error("the matrix ends, expected three rows of three numbers");
      }
    }
    return new Homography(h);
  }

  private static int row(Fields fields, double[] h, int count) {
    if (fields.count() != SIZE || count == h.length) {
      throw fields.place(0).error("expected a matrix of three rows of three numbers");
    }
    for (int i = 0; i < SIZE; i++) {
      h[count + i] = fields.number(i, "the number");
    }
    return count + SIZE;
  }

  @Override
  public Sample onGround(Sample sample) {
    double x = x(sample.x(), sample.y());
    double y = y(sample.x(), sample.y());
    if (!(Math.abs(x) <= 1e9 && Math.abs(y) <= 1e9)) {
      throw sample
          .place()
          .error(
              "the homography takes (%s, %s) to (%s, %s), expected a place nearer"
                  .formatted(sample.x(), sample.y(), x, y));
    }
    double half = sample.width() / 2;
    double width =
        Math.hypot(
            x(sample.x() + half, sample.y()) - x(sample.x() - half, sample.y()),
            y(sample.x() + half, sample.y()) - y(sample.x() - half, sample.y()));
    double height = width * sample.height() / sample.width();
    return new Sample(sample.place(), sample.target(), sample.tick(), x, y, width, height);
  }

  private double x(double u, double v) {
    return (h[0] * u + h[1] * v + h[2]) / depth(u, v);
  }

  private double y(double u, double v) {
    return (h[3] * u + h[4] * v + h[5]) / depth(u, v);
  }

  private double depth(double u, double v) {
    return h[6] * u + h[7] * v + h[8];
  }
}
