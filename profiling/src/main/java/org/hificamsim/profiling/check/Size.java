package org.hificamsim.profiling.check;

/** Width and height: of a box or a picture in pixels, of a body in metres. */
public record Size(double width, double height) {
  double area() {
    return width * height;
  }

  @Override
  public String toString() {
    return Math.round(width) + "x" + Math.round(height);
  }
}
