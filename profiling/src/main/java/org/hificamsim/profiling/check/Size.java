package org.hificamsim.profiling.check;

/** Width and height of a box, pixels. */
record Size(double width, double height) {
  double area() {
    return width * height;
  }
}
