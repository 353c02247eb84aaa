package org.hificamsim.hifi.feature;

/**
 * The pinhole camera {@code PIP = (z q / d)^2 / sensor area}, clipped at 1, for a square target
 * that faces the camera. Nothing is fitted.
 *
 * @param sensorWidth width of the image sensor, in metres, above 0
 * @param sensorHeight height of the image sensor, in metres, above 0
 */
public record PinholeAbstraction(double sensorWidth, double sensorHeight)
    implements FeatureAbstraction {
  /** The predicted PIP; a target on the camera fills the image (1) at any focal length. */
  @Override
  public double pip(double size, double distance, double focalLength) {
    if (distance == 0) {
      return 1;
    }
    double side = focalLength * size / distance;
    return Math.min(1, side * side / (sensorWidth * sensorHeight));
  }
}
