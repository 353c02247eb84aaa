package org.hificamsim.profiling.fit;

/**
 * An estimated coefficient.
 *
 * @param name the variable that it weighs, or {@code intercept}
 * @param error the standard error; NaN if the method gives none
 * @param low the lower end of the 95% confidence interval
 * @param high the upper end of the 95% confidence interval
 */
public record Coefficient(String name, double value, double error, double low, double high) {
  /** Returns a coefficient without an error. */
  static Coefficient withoutError(String name, double value) {
    return new Coefficient(name, value, Double.NaN, Double.NaN, Double.NaN);
  }
}
