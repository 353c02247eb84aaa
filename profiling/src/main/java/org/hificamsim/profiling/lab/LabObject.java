package org.hificamsim.profiling.lab;

import java.util.List;

/**
 * One of the eight objects of the experiment: flat, textured, facing the camera. Their sizes span
 * thesis 3.5's 0.10 to 0.66 m with the mean 0.31 m and standard deviation 0.20 m of Table 4.1.
 *
 * @param name the short name in files
 * @param size width, in metres
 * @param aspect height over width
 * @param round whether it is an ellipse instead of a rectangle
 * @param photo the name of the photograph on it
 */
record LabObject(String name, double size, double aspect, boolean round, String photo) {
  static final List<LabObject> ALL =
      List.of(
          new LabObject("matchbox", 0.10, 0.9, false, "coffee"),
          new LabObject("tin", 0.12, 1.0, false, "coins"),
          new LabObject("puzzle", 0.16, 0.95, false, "china"),
          new LabObject("ball", 0.22, 1.0, true, "hubble_deep_field"),
          new LabObject("circuit", 0.30, 0.9, false, "rocket"),
          new LabObject("cushion", 0.40, 1.0, false, "chelsea"),
          new LabObject("tray", 0.52, 1.0, true, "raccoon"),
          new LabObject("poster", 0.66, 0.95, false, "astronaut"));

  /** Returns the size q of thesis 3.5, in metres: the root of width times height. */
  double q() {
    return Math.sqrt(size * height());
  }

  double height() {
    return size * aspect;
  }
}
