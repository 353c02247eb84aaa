package org.hificamsim.agents.observation;

/** Keeps numbers within the bounds that a layout promises; NaN becomes 0. */
final class Bounds {
  private Bounds() {}

  /** Returns the value kept within -1 and 1. */
  static float signed(double value) {
    return value >= -1 && value <= 1 ? (float) value : value > 1 ? 1 : value < -1 ? -1 : 0;
  }

  /** Returns the shares 0, 1/total, 2/total to 1; a total of 0 counts as 1. */
  static float[] shares(int total) {
    float[] shares = new float[Math.max(1, total) + 1];
    for (int part = 0; part < shares.length; part++) {
      shares[part] = share((double) part / (shares.length - 1));
    }
    return shares;
  }

  /** Returns the value kept within 0 and 1. */
  static float share(double value) {
    return value >= 0 && value <= 1 ? (float) value : value > 1 ? 1 : 0;
  }
}
