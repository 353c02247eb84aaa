package org.hificamsim.agents.observation;

/** The shares 0, 1 / whole to 1, divided once. */
final class Shares {
  private final float[] shares;

  /**
   * @param whole 1 or more
   */
  Shares(int whole) {
    shares = new float[whole + 1];
    for (int part = 0; part <= whole; part++) {
      shares[part] = Bounds.share((double) part / whole);
    }
  }

  /** A part as a share; 1 for what is more than the whole, as detections with phantoms may be. */
  float of(int part) {
    return shares[Math.min(part, shares.length - 1)];
  }
}
