package org.hificamsim.profiling.lab;

/**
 * What is painted on a surface: how many of each shape, and how strong the grain is.
 *
 * <p>The numbers are ours: enough corners for feature detectors, and eight surfaces that differ.
 */
enum Pattern {
  PRINT(20, 4, 0, 10, 26, 0.02),
  MOSAIC(0, 0, 140, 0, 0, 0.015),
  BALL(0, 26, 30, 24, 4, 0.02),
  CAMOUFLAGE(0, 50, 60, 0, 0, 0.06),
  CIRCUIT(90, 40, 0, 60, 12, 0.012),
  DOTS(0, 160, 0, 0, 6, 0.02),
  POSTER(10, 8, 16, 6, 14, 0.025),
  LABELS(50, 10, 20, 20, 18, 0.02);

  private final int rectangles;
  private final int circles;
  private final int polygons;
  private final int lines;
  private final int words;
  private final double grain;

  Pattern(int rectangles, int circles, int polygons, int lines, int words, double grain) {
    this.rectangles = rectangles;
    this.circles = circles;
    this.polygons = polygons;
    this.lines = lines;
    this.words = words;
    this.grain = grain;
  }

  int rectangles() {
    return rectangles;
  }

  int circles() {
    return circles;
  }

  int polygons() {
    return polygons;
  }

  int lines() {
    return lines;
  }

  int words() {
    return words;
  }

  /** Standard deviation of the grain, as a share of white. */
  double grain() {
    return grain;
  }
}
