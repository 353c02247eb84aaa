package org.hificamsim.core.detection;

/**
 * The standard normal distribution to about 1e-15, by a Taylor series about the nearest of 257
 * points; fast enough for the step.
 */
final class NormalDistribution {
  private static final int PER_UNIT = 16;

  /**
   * The number of standard deviations beyond which the distribution function is 0 or 1 in double
   * precision.
   */
  private static final int END = 8;

  private static final double[] CDF = new double[2 * END * PER_UNIT + 1];
  private static final double[] DENSITY = new double[CDF.length];

  static {
    for (int i = 0; i < CDF.length; i++) {
      double x = (double) i / PER_UNIT - END;
      DENSITY[i] = StrictMath.exp(-x * x / 2) / Math.sqrt(2 * Math.PI);
      CDF[i] = bySeries(x, DENSITY[i]);
    }
  }

  private NormalDistribution() {}

  /**
   * Computes the distribution function by a series (Marsaglia, "Evaluating the normal
   * distribution", Journal of Statistical Software 11, 2004).
   */
  private static double bySeries(double x, double density) {
    double term = x;
    double sum = x;
    for (int n = 3; Math.abs(term) > 1e-17 * Math.abs(sum); n += 2) {
      term *= x * x / n;
      sum += term;
    }
    return 0.5 + sum * density;
  }

  /** The chance that a standard normal number is at most x, in [0, 1]; NaN for NaN. */
  static double cdf(double x) {
    if (!(Math.abs(x) < END)) {
      return x < 0 ? 0 : x > 0 ? 1 : x;
    }
    int i = (int) Math.rint((x + END) * PER_UNIT);
    double a = (double) i / PER_UNIT - END;
    return CDF[i] + DENSITY[i] * series(a, x - a);
  }

  /** The integral of the density from a to a + h over the density at a, by Hermite polynomials. */
  private static double series(double a, double h) {
    double a2 = a * a;
    double he2 = a2 - 1;
    double he3 = a * (a2 - 3);
    double he4 = a2 * (a2 - 6) + 3;
    double he5 = a * (a2 * (a2 - 10) + 15);
    double he6 = a2 * (a2 * (a2 - 15) + 45) - 15;
    double sum = he6 / 5040;
    sum = sum * h - he5 / 720;
    sum = sum * h + he4 / 120;
    sum = sum * h - he3 / 24;
    sum = sum * h + he2 / 6;
    sum = sum * h - a / 2;
    return h * (sum * h + 1);
  }

  /**
   * Returns the number below which a standard normal number is with this chance.
   *
   * @param chance the chance in (0, 1)
   */
  static double quantile(double chance) {
    double low = -END;
    double high = END;
    while (true) {
      double middle = (low + high) / 2;
      if (middle <= low || middle >= high) {
        return middle;
      }
      if (cdf(middle) < chance) {
        low = middle;
      } else {
        high = middle;
      }
    }
  }
}
