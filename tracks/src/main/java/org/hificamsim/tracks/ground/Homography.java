package org.hificamsim.tracks.ground;

import java.nio.file.Path;
import org.hificamsim.tracks.format.TrackSample;

/**
 * Converts pixels (to the right, down) to metres on the ground: (x w, y w, w) = H (u, v, 1). The
 * width of a box is that of its lower edge on the ground; the ratio of height and width stays.
 */
public final class Homography implements Ground {
  private final double[] h;

  private Homography(double[] h) {
    this.h = h;
  }

  /**
   * Reads three rows of three numbers, separated by spaces.
   *
   * @throws org.hificamsim.core.InputException with the place, if the file has anything else
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
              "the homography converts (%s, %s) to (%s, %s), expected a place within 1e9 m",
              sample.x(), sample.y(), x, y);
    }
    double halfWidth = sample.width() / 2;
    double width =
        Math.hypot(
            x(sample.x() + halfWidth, sample.y()) - x(sample.x() - halfWidth, sample.y()),
            y(sample.x() + halfWidth, sample.y()) - y(sample.x() - halfWidth, sample.y()));
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
