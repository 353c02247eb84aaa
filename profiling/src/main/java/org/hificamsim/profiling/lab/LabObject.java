package org.hificamsim.profiling.lab;

import java.util.List;

/**
 * One of the eight objects of the experiment: flat, textured, facing the camera. Their sizes span
 * thesis 3.5's 0.10 to 0.66 m with the mean 0.31 m and standard deviation 0.20 m of Table 4.1.
 *
 * @param name short name in files
 * @param size width q, metres
 * @param aspect height over width
 * @param round an ellipse rather than a rectangle
 */
record LabObject(String name, double size, double aspect, boolean round, Pattern pattern) {
  static final List<LabObject> ALL =
      List.of(
          new LabObject("matchbox", 0.10, 0.9, false, Pattern.LABELS),
          new LabObject("tin", 0.12, 1.0, false, Pattern.PRINT),
          new LabObject("puzzle", 0.16, 0.95, false, Pattern.MOSAIC),
          new LabObject("ball", 0.22, 1.0, true, Pattern.BALL),
          new LabObject("circuit", 0.30, 0.9, false, Pattern.CIRCUIT),
          new LabObject("cushion", 0.40, 1.0, false, Pattern.CAMOUFLAGE),
          new LabObject("tray", 0.52, 1.0, true, Pattern.DOTS),
          new LabObject("poster", 0.66, 0.95, false, Pattern.POSTER));

  double height() {
    return size * aspect;
  }
}
