package org.hificamsim.hifi.feature;

/**
 * A feature abstraction f: predicts the patch image proportion (PIP), the share of the image that a
 * target fills, from physical properties (thesis 3.4.1).
 *
 * <p>Implement {@link #pip}, or, for an abstraction that predicts {@code -log10(PIP)}, as the
 * published regressions do, {@link LogPipAbstraction}. A type that model files may hold also needs
 * a line in {@code FeatureFormats}.
 */
public interface FeatureAbstraction {
  /**
   * Returns the predicted PIP, in [0, 1]; NaN if the formula has no value.
   *
   * @param size target size q, in metres, above 0
   * @param distance camera-target distance d, in metres, 0 or more
   * @param focalLength focal length z, in metres, 0 or more
   */
  double pip(double size, double distance, double focalLength);
}
