package org.hificamsim.agents.observation;

/** Numbers kept within the bounds that a layout promises; no number is 0. */
final class Bounds {
  private Bounds() {}

  static float signed(double value) {
    return value >= -1 && value <= 1 ? (float) value : value > 1 ? 1 : value < -1 ? -1 : 0;
  }

  /** The shares 0, 1 / whole to 1, divided once; of 1 where the whole is 0. */
  static float[] shares(int whole) {
    float[] shares = new float[Math.max(1, whole) + 1];
    for (int part = 0; part < shares.length; part++) {
      shares[part] = share((double) part / (shares.length - 1));
    }
    return shares;
  }

  static float share(double value) {
    return value >= 0 && value <= 1 ? (float) value : value > 1 ? 1 : 0;
  }
}
