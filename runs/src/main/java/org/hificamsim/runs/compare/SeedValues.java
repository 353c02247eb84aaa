package org.hificamsim.runs.compare;

import java.util.Arrays;
import org.hificamsim.runs.Estimate;

/**
 * What is known of a figure: one value for each run that has one.
 *
 * @param values by rising seed; those that are NaN are left out
 */
public record SeedValues(double[] values) {
  public SeedValues {
    values = Arrays.stream(values).filter(value -> !Double.isNaN(value)).toArray();
  }

  /** The differences of paired values. */
  static SeedValues ofDifferences(double[] values, double[] paired) {
    double[] differences = new double[values.length];
    Arrays.setAll(differences, i -> values[i] - paired[i]);
    return new SeedValues(differences);
  }

  /** How many runs have a value. */
  public int size() {
    return values.length;
  }

  /** The mean with its 95% interval, of which a single run has none. */
  public Estimate mean() {
    return Bootstrap.mean(values);
  }
}
