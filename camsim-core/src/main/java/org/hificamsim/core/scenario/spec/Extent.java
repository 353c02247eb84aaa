package org.hificamsim.core.scenario.spec;

/**
 * The width and height of a target, in metres, above 0. Its size q is the edge of the square with
 * the same area; its width hides others.
 */
public record Extent(double width, double height) {
  /** A person of a usual size. */
  public static final Extent PERSON = new Extent(0.5, 1.75);

  /** The edge of the square with the same area, in metres. */
  public double size() {
    return Math.sqrt(width * height);
  }
}
