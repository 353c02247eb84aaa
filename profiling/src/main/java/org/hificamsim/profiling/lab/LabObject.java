package org.hificamsim.profiling.lab;

import java.util.List;

/**
 * One of the eight objects of the experiment: flat, textured, facing the camera. Their sizes span
 * thesis 3.5's 0.10 to 0.66 m with the mean 0.31 m and standard deviation 0.20 m of Table 4.1.
 *
 * @param name short name in files
 * @param size width, metres
 * @param aspect height over width
 * @param round an ellipse rather than a rectangle
 * @param pattern what is painted on it
 * @param photo what is on it otherwise
 */
record LabObject(
    String name, double size, double aspect, boolean round, Pattern pattern, String photo) {
  static final List<LabObject> ALL =
      List.of(
          new LabObject("matchbox", 0.10, 0.9, false, Pattern.LABELS, "coffee"),
          new LabObject("tin", 0.12, 1.0, false, Pattern.PRINT, "coins"),
          new LabObject("puzzle", 0.16, 0.95, false, Pattern.MOSAIC, "china"),
          new LabObject("ball", 0.22, 1.0, true, Pattern.BALL, "hubble_deep_field"),
          new LabObject("circuit", 0.30, 0.9, false, Pattern.CIRCUIT, "rocket"),
          new LabObject("cushion", 0.40, 1.0, false, Pattern.CAMOUFLAGE, "chelsea"),
          new LabObject("tray", 0.52, 1.0, true, Pattern.DOTS, "raccoon"),
          new LabObject("poster", 0.66, 0.95, false, Pattern.POSTER, "astronaut"));

  /** The size q of thesis 3.5, metres: the root of width times height. */
  double q() {
    return Math.sqrt(size * height());
  }

  double height() {
    return size * aspect;
  }
}
