package org.hificamsim.core.scenario.spec;

/** The rectangle that targets move in, metres; its border belongs to it. */
public record Field(double minX, double maxX, double minY, double maxY) {
  /** Whether the point lies inside or on the border. */
  public boolean contains(double x, double y) {
    return !(x > maxX || x < minX || y > maxY || y < minY);
  }

  /** The width, in metres. */
  public double width() {
    return maxX - minX;
  }

  /** The height, in metres. */
  public double height() {
    return maxY - minY;
  }
}
