package org.hificamsim.hifi.feature;

/**
 * A feature abstraction f: predicts the patch image proportion (PIP), the share of the image that a
 * target fills, from physical properties (thesis 3.4.1).
 *
 * <p>An implementer writes {@link #pip}; one that predicts {@code -log10(PIP)}, as the published
 * regressions do, implements {@link LogPipAbstraction} instead. To be read from and written to
 * model files, a type also needs its line in {@code FeatureFormats}.
 */
public interface FeatureAbstraction {
  /**
   * The predicted PIP, in [0, 1]; NaN where the formula has no value.
   *
   * @param size target size q, metres, above 0
   * @param distance camera-target distance d, metres, 0 or more
   * @param focalLength focal length z, metres, 0 or more
   */
  double pip(double size, double distance, double focalLength);
}
