package org.hificamsim.agents.observation;

/** Numbers kept within the bounds that a layout promises; no number is 0. */
final class Bounds {
  private Bounds() {}

  static float signed(double value) {
    return value >= -1 && value <= 1 ? (float) value : value > 1 ? 1 : value < -1 ? -1 : 0;
  }

  static float share(double value) {
    return value >= 0 && value <= 1 ? (float) value : value > 1 ? 1 : 0;
  }
}
