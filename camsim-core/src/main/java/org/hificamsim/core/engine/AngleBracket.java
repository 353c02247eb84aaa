package org.hificamsim.core.engine;

/**
 * An angle between 0 and pi, from its cosine, to within {@value #ERROR} radians: many times cheaper
 * than an arc cosine, and near enough to tell most decisions apart.
 *
 * <p>By the polynomial of Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.46, whose
 * error is at most 2e-8. Where the cosine is no number or outside [-1, 1], so is the angle, as with
 * {@link Math#acos}.
 */
final class AngleBracket {
  /** Radians, rounding included. */
  static final double ERROR = 3e-8;

  private AngleBracket() {}

  /** Near the angle, radians. */
  static double near(double cosine) {
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

  /** At most the angle that {@link #near} is near to. */
  static double least(double near) {
    return Math.max(0, near - ERROR);
  }

  /** At least the angle that {@link #near} is near to. */
  static double most(double near) {
    return Math.min(Math.PI, near + ERROR);
  }
}
