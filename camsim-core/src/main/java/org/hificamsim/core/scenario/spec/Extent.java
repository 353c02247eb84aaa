package org.hificamsim.core.scenario.spec;

/**
 * The width and height of a target, metres, above 0. Its size q is the edge of the square with the
 * same area; its width hides others.
 */
public record Extent(double width, double height) {
  /** The edge of the square with the same area, metres. */
  public double size() {
    return Math.sqrt(width * height);
  }
}
