package org.hificamsim.hifi.feature;

/**
 * The linear regression {@code -log10(PIP) = z*focalLength + q*size + d*distance + intercept}: Eq
 * 4.4 (multiple linear regression) and Eq 4.11 (support vector regression with a linear kernel).
 *
 * @param z weight of the focal length, per metre
 * @param q weight of the target size, per metre
 * @param d weight of the distance, per metre
 * @param intercept the constant term
 */
public record LinearAbstraction(double z, double q, double d, double intercept)
    implements LogPipAbstraction {
  @Override
  public double negativeLogPip(double size, double distance, double focalLength) {
    return z * focalLength + q * size + d * distance + intercept;
  }
}
