package org.hificamsim.core.engine;

/**
 * An angle between 0 and pi, from its cosine, to within {@value #ERROR} radians: many times faster
 * than an arc cosine, and close enough for most decisions.
 *
 * <p>By the polynomial of Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.46, whose
 * error is at most 2e-8. Where the cosine is NaN or outside [-1, 1], the angle is NaN, as with
 * {@link Math#acos}.
 */
final class AngleBracket {
  /** Radians, rounding included. */
  static final double ERROR = 3e-8;

  private AngleBracket() {}

  /** About the angle, radians. */
  static double about(double cosine) {
    double c = Math.abs(cosine);
    double sum = -0.0012624911;
    sum = sum * c + 0.0066700901;
    sum = sum * c - 0.0170881256;
    sum = sum * c + 0.0308918810;
    sum = sum * c - 0.0501743046;
    sum = sum * c + 0.0889789874;
    sum = sum * c - 0.2145988016;
    sum = sum * c + 1.5707963050;
    double angle = Math.sqrt(1 - c) * sum;
    return cosine < 0 ? Math.PI - angle : angle;
  }

  /** At most the angle that {@link #about} approximates. */
  static double lower(double about) {
    return Math.max(0, about - ERROR);
  }

  /** At least the angle that {@link #about} approximates. */
  static double upper(double about) {
    return Math.min(Math.PI, about + ERROR);
  }
}
