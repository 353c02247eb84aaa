package org.hificamsim.core.scenario.spec;

/**
 * How wide and high a target is, metres, above 0. Its size q is the edge of the square with the
 * same area; its width is what hides others.
 */
public record Extent(double width, double height) {
  /** The edge of a square as large, metres. */
  public double size() {
    return Math.sqrt(width * height);
  }
}
