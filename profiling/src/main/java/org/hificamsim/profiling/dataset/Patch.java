package org.hificamsim.profiling.dataset;

/** The rectangle of a picture that holds the object, pixels; width and height are 1 or more. */
public record Patch(int x, int y, int width, int height) {
  /** Its number of pixels. */
  public long area() {
    return (long) width * height;
  }

  /** Whether a point of the picture is on it. */
  public boolean has(double right, double down) {
    return right >= x && down >= y && right < x + width && down < y + height;
  }

  boolean within(int imageWidth, int imageHeight) {
    return x >= 0 && y >= 0 && (long) x + width <= imageWidth && (long) y + height <= imageHeight;
  }

  @Override
  public String toString() {
    return width + " x " + height + " at (" + x + ", " + y + ")";
  }
}
