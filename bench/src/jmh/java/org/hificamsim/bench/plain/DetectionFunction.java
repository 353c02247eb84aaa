package org.hificamsim.bench.plain;

/** Decides whether a camera detects a target at its present level. */
interface DetectionFunction {
  boolean detects(Camera camera, Target target);

  /** Returns the function of a detection model. */
  static DetectionFunction named(String name) {
    return switch (name) {
      case "hifi:orb-lin" -> new HiFiFunction();
      case "camsim-range@0.3" -> new RangeFunction();
      default -> throw new IllegalArgumentException("no plain detection '" + name + "'");
    };
  }
}
