package org.hificamsim.core.visibility;

import java.util.Comparator;

/**
 * What a camera has to see of a target.
 *
 * @param size edge of its bounding box, metres, above 0
 * @param low the least height that has to be seen, metres
 * @param high the greatest
 * @param foreshortened whether it looks shorter from above
 */
public record Body(double size, double low, double high, boolean foreshortened) {
  /** By size, and then by the rest. */
  public static final Comparator<Body> ORDER =
      Comparator.comparingDouble(Body::size)
          .thenComparingDouble(Body::low)
          .thenComparingDouble(Body::high);

  /** A target in a world without heights. */
  public static Body flat(double size) {
    return new Body(size, 0, 0, false);
  }

  /** The height to which distances are measured: the middle of what has to be seen. */
  public double middle() {
    return (low + high) / 2;
  }
}
