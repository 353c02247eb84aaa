package org.hificamsim.hifi.feature;

/**
 * A feature abstraction that predicts {@code -log10(PIP)}, the response of the regressions in
 * thesis 4.3.
 *
 * <p>Implement {@link #negativeLogPip}; {@link #pip} transforms it back.
 */
public interface LogPipAbstraction extends FeatureAbstraction {
  /**
   * Returns the predicted {@code -log10(PIP)}, unbounded. A value below 0 means a patch larger than
   * the image.
   *
   * @param size target size q, in metres, above 0
   * @param distance camera-target distance d, in metres, 0 or more
   * @param focalLength focal length z, in metres, 0 or more
   */
  double negativeLogPip(double size, double distance, double focalLength);

  /** {@code min(1, 10^(-f))}, with the same result on every machine. */
  @Override
  default double pip(double size, double distance, double focalLength) {
    return Math.min(1, StrictMath.pow(10, -negativeLogPip(size, distance, focalLength)));
  }
}
