package org.hificamsim.tracks.ground;

import java.nio.file.Path;
import org.hificamsim.tracks.format.TrackSample;

/**
 * Takes pixels (to the right, down) to metres on the ground: (x w, y w, w) = H (u, v, 1). A box as
 * wide as it is in the picture stands on the ground where its lower edge is; its height is to its
 * width as in the picture.
 */
public final class Homography implements Ground {
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
    return new Homography(MatrixFile.read(file, 3, 3, "a matrix of three rows of three numbers"));
  }

  @Override
  public TrackSample onGround(TrackSample sample) {
    double x = x(sample.x(), sample.y());
    double y = y(sample.x(), sample.y());
    if (!(Math.abs(x) <= 1e9 && Math.abs(y) <= 1e9)) {
      throw sample
          .place()
          .error(
              "the homography takes (%s, %s) to (%s, %s), expected a place nearer",
              sample.x(), sample.y(), x, y);
    }
    double half = sample.width() / 2;
    double width =
        Math.hypot(
            x(sample.x() + half, sample.y()) - x(sample.x() - half, sample.y()),
            y(sample.x() + half, sample.y()) - y(sample.x() - half, sample.y()));
    double height = width * sample.height() / sample.width();
    return sample.at(x, y, width, height);
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
