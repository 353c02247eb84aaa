package org.hificamsim.profiling.dataset;

/** The rectangle of a picture that holds the object, in pixels; width and height are 1 or more. */
public record Patch(int x, int y, int width, int height) {
  /** Returns the number of pixels. */
  public long area() {
    return (long) width * height;
  }

  /** Whether the patch contains a point of the picture. */
  public boolean contains(double pointX, double pointY) {
    return pointX >= x && pointY >= y && pointX < x + width && pointY < y + height;
  }

  boolean within(int imageWidth, int imageHeight) {
    return x >= 0 && y >= 0 && (long) x + width <= imageWidth && (long) y + height <= imageHeight;
  }

  @Override
  public String toString() {
    return width + " x " + height + " at (" + x + ", " + y + ")";
  }
}
