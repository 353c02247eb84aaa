package org.hificamsim.hifi.feature;

/**
 * The power law {@code PIP = c * z^a * q^b * d^-e}, clipped at 1. A least-squares line through the
 * logarithms of all variables gives it. The pinhole camera is the case {@code a = b = e = 2}.
 *
 * @param c the factor, above 0
 * @param a exponent of the focal length (metres)
 * @param b exponent of the target size (metres)
 * @param e how fast PIP falls: the negated exponent of the distance (metres)
 */
public record PowerLawAbstraction(double c, double a, double b, double e)
    implements FeatureAbstraction {
  /** The predicted PIP; a target on the camera fills the image (1) at any focal length. */
  @Override
  public double pip(double size, double distance, double focalLength) {
    if (distance == 0) {
      return 1;
    }
    return Math.min(
        1,
        c
            * StrictMath.pow(focalLength, a)
            * StrictMath.pow(size, b)
            * StrictMath.pow(distance, -e));
  }
}
