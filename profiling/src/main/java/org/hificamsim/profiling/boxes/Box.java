package org.hificamsim.profiling.boxes;

/**
 * A rectangle in a picture, in pixels.
 *
 * @param left distance from the picture's left edge
 * @param top distance from its upper edge, downwards
 * @param width above 0
 * @param height above 0
 */
public record Box(double left, double top, double width, double height) {
  double right() {
    return left + width;
  }

  double bottom() {
    return top + height;
  }

  double area() {
    return width * height;
  }

  /** Returns the intersection over union with another box, in [0, 1]. */
  double overlap(Box other) {
    double across = Math.min(right(), other.right()) - Math.max(left, other.left);
    double down = Math.min(bottom(), other.bottom()) - Math.max(top, other.top);
    double shared = Math.max(0, across) * Math.max(0, down);
    return shared / (area() + other.area() - shared);
  }
}
