package org.hificamsim.profiling.check;

/**
 * A place in a picture.
 *
 * @param u pixels to the right of the picture's left edge
 * @param v pixels down from its upper edge
 */
record Pixel(double u, double v) {
  /** Nowhere in any picture. */
  static final Pixel NONE = new Pixel(Double.NaN, Double.NaN);

  /** How far another place is, pixels. */
  double distance(Pixel other) {
    return Math.hypot(u - other.u, v - other.v);
  }
}
