package org.hificamsim.core.visibility;

import java.util.Comparator;

/**
 * The part of a target that a camera must see.
 *
 * @param size the size of the target as the detection model takes it, in metres, above 0: the edge
 *     of its bounding box, or its height
 * @param low the lowest height that must be seen, in metres
 * @param high the greatest height that must be seen, in metres
 * @param foreshortened whether the target looks shorter from above
 */
public record Body(double size, double low, double high, boolean foreshortened) {
  /** The order of bodies by size, then by heights. */
  public static final Comparator<Body> ORDER =
      Comparator.comparingDouble(Body::size)
          .thenComparingDouble(Body::low)
          .thenComparingDouble(Body::high);

  /** Returns the body of a target in a world without heights. */
  public static Body flat(double size) {
    return new Body(size, 0, 0, false);
  }

  /** The height to which distances are measured: the middle of the part to be seen. */
  public double middle() {
    return (low + high) / 2;
  }
}
