package org.hificamsim.presentation.plot;

import org.apache.commons.math3.analysis.interpolation.LoessInterpolator;

/**
 * Smooths curves by locally weighted regression (Cleveland 1979), as in the figures of chapter 7 of
 * the thesis. Long curves are thinned to means of neighbours first, which changes far less than
 * smoothing does.
 */
public final class Lowess {
  /** The share of points to which each local line is fitted. */
  public static final double BANDWIDTH = 0.1;

  private static final int MAX_POINTS = 500;
  private static final int MIN_POINTS = 20;
  private static final int ROBUSTNESS_PASSES = 0;

  private Lowess() {}

  /** Whether a curve of this many points is smoothed. */
  public static boolean smooths(int points) {
    return points >= MIN_POINTS;
  }

  /** Returns the smooth curve; a curve of fewer than 20 points stays as it is. */
  public static Curve smooth(Curve curve) {
    if (!smooths(curve.size())) {
      return curve;
    }
    Curve thin = curve.thinned(MAX_POINTS);
    double bandwidth = Math.max(BANDWIDTH, 4.0 / thin.size());
    return new Curve(
        thin.x(), new LoessInterpolator(bandwidth, ROBUSTNESS_PASSES).smooth(thin.x(), thin.y()));
  }
}
