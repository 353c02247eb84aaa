package org.hificamsim.profiling.fit;

/**
 * An estimated coefficient.
 *
 * @param name the variable that it weighs, or {@code intercept}
 * @param error standard error; NaN where the method gives none
 * @param low lower end of the 95% confidence interval
 * @param high upper end of the 95% confidence interval
 */
public record Coefficient(String name, double value, double error, double low, double high) {
  /** A coefficient of a method that gives no error. */
  static Coefficient plain(String name, double value) {
    return new Coefficient(name, value, Double.NaN, Double.NaN, Double.NaN);
  }
}
