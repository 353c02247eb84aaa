package org.hificamsim.core.detection;

/**
 * Under which conditions a camera sees, as far as the scenario says.
 *
 * @param aperture f-number N of the lens; NaN where it is not known
 * @param distortion k of the lens; NaN where it is not known
 * @param light how bright the scene is; NaN where it is not known
 */
public record Conditions(double aperture, double distortion, double light) {
  /** Nothing is known. */
  public static final Conditions UNKNOWN = new Conditions(Double.NaN, Double.NaN, Double.NaN);

  /** The value of one; NaN where it is not known. */
  public double value(Condition condition) {
    return switch (condition) {
      case APERTURE -> aperture;
      case DISTORTION -> distortion;
      case LIGHT -> light;
    };
  }

  /** The same with another's values where these are not known. */
  public Conditions or(Conditions other) {
    return new Conditions(
        known(aperture, other.aperture),
        known(distortion, other.distortion),
        known(light, other.light));
  }

  private static double known(double own, double other) {
    return Double.isNaN(own) ? other : own;
  }
}
