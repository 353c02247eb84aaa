package org.hificamsim.profiling.lab;

import java.util.List;

/**
 * What is painted on a surface: how many of each shape, and how strong the grain is.
 *
 * <p>The numbers are ours: enough corners for feature detectors, and eight surfaces that differ.
 *
 * @param grain standard deviation, as a share of white
 */
record Pattern(int rectangles, int circles, int polygons, int lines, int words, double grain) {
  static final Pattern PRINT = new Pattern(20, 4, 0, 10, 26, 0.02);
  static final Pattern MOSAIC = new Pattern(0, 0, 140, 0, 0, 0.015);
  static final Pattern BALL = new Pattern(0, 26, 30, 24, 4, 0.02);
  static final Pattern CAMOUFLAGE = new Pattern(0, 50, 60, 0, 0, 0.06);
  static final Pattern CIRCUIT = new Pattern(90, 40, 0, 60, 12, 0.012);
  static final Pattern DOTS = new Pattern(0, 160, 0, 0, 6, 0.02);
  static final Pattern POSTER = new Pattern(10, 8, 16, 6, 14, 0.025);
  static final Pattern LABELS = new Pattern(50, 10, 20, 20, 18, 0.02);

  static final List<Pattern> ALL =
      List.of(PRINT, MOSAIC, BALL, CAMOUFLAGE, CIRCUIT, DOTS, POSTER, LABELS);
}
