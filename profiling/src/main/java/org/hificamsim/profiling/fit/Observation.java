package org.hificamsim.profiling.fit;

/**
 * One row of a regression of f (chapter 4).
 *
 * @param size q, metres
 * @param distance d, metres
 * @param focalLength z, metres
 * @param pip ground truth, (0, 1]
 */
public record Observation(double size, double distance, double focalLength, double pip) {
  /** The response of the regressions: {@code -log10(PIP)} (thesis 4.3). */
  public double response() {
    return -StrictMath.log10(pip);
  }

  /** The predictors in the order q, d, z. */
  public double[] predictors() {
    return new double[] {size, distance, focalLength};
  }
}
