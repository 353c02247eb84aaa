package org.hificamsim.core.visibility;

/**
 * Computes {@link StrictMath#acos} without its native call, with the same bits.
 *
 * <p>Uses the method and coefficients of FDLIBM 5.3 (Sun Microsystems 1993, netlib.org/fdlibm),
 * which defines {@link StrictMath}, in its order of operations, since each is rounded. With asin(x)
 * = x + x {@link #excess}(x^2): near pi/2, acos(x) is pi/2 - asin(x). An angle below pi/3 is twice
 * the arc sine of the sine of its half; for an angle above 2 pi/3, its supplement is computed in
 * this way.
 */
final class ArcCosine {
  private static final double HALF_PI = Math.PI / 2;

  /** The difference between pi/2 and {@link #HALF_PI}. */
  private static final double HALF_PI_REST = 0x1.1a62633145c07p-54;

  /** The bits that remain of a root so that its square is exact. */
  private static final long UPPER_HALF = 0xffff_ffff_0000_0000L;

  private static final double P0 = 0x1.5555555555555p-3;
  private static final double P1 = -0x1.4d61203eb6f7dp-2;
  private static final double P2 = 0x1.9c1550e884455p-3;
  private static final double P3 = -0x1.48228b5688f3bp-5;
  private static final double P4 = 0x1.9efe07501b288p-11;
  private static final double P5 = 0x1.23de10dfdf709p-15;
  private static final double Q1 = -0x1.33a271c8a2d4bp1;
  private static final double Q2 = 0x1.02ae59c598ac8p1;
  private static final double Q3 = -0x1.6066c1b8d0159p-1;
  private static final double Q4 = 0x1.3b8c5b12e9282p-4;

  private ArcCosine() {}

  /** Returns the angle of a cosine, in radians, in [0, pi]; NaN for NaN and outside [-1, 1]. */
  static double of(double cosine) {
    if (Math.abs(cosine) < 0.5) {
      return HALF_PI - (cosine - (HALF_PI_REST - cosine * excess(cosine * cosine)));
    }
    return cosine < 0 ? Math.PI - supplement((1 + cosine) / 2) : acute((1 - cosine) / 2);
  }

  /**
   * Returns the supplement of an angle, before the rest of pi is added.
   *
   * @param square the square of the cosine of half the angle
   */
  private static double supplement(double square) {
    double sine = Math.sqrt(square);
    return 2 * (sine + (excess(square) * sine - HALF_PI_REST));
  }

  /**
   * Returns an angle below pi/3.
   *
   * @param square the square of the sine of half the angle; its root is split to make up for its
   *     rounding
   */
  private static double acute(double square) {
    if (square == 0) {
      return 0; // not 0/0
    }
    double sine = Math.sqrt(square);
    double upper = Double.longBitsToDouble(Double.doubleToRawLongBits(sine) & UPPER_HALF);
    double lower = (square - upper * upper) / (sine + upper);
    return 2 * (upper + (excess(square) * sine + lower));
  }

  /** Returns (asin(x) - x) / x for the square of x, at most 1/4. */
  private static double excess(double square) {
    double p = P0 + square * (P1 + square * (P2 + square * (P3 + square * (P4 + square * P5))));
    double q = 1 + square * (Q1 + square * (Q2 + square * (Q3 + square * Q4)));
    return square * p / q;
  }
}
