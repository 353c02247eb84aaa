package org.hificamsim.presentation.replay;

import org.hificamsim.core.scenario.spec.Field;

/**
 * Converts numbers to whole multiples of a power of ten. These take few bytes, and keep decimals
 * exact.
 *
 * @param perUnit the number of parts of a unit
 */
record Scale(double perUnit) {
  private static final double SMALLEST = 1e-6;

  /**
   * Returns a scale of millimetres, which is finer for fields below 10 m and coarser for huge ones.
   */
  static Scale of(Field field) {
    double magnitude = magnitude(Math.max(field.width(), field.height()));
    return new Scale(Math.pow(10, Math.min(Math.max(3, 4 - magnitude), 12 - magnitude)));
  }

  /** Returns a scale with five digits for the largest number. */
  static Scale of(double largest) {
    return new Scale(Math.pow(10, 4 - magnitude(largest)));
  }

  private static double magnitude(double number) {
    return Math.floor(Math.log10(Math.max(SMALLEST, number)));
  }

  long pack(double number) {
    return Math.round(number * perUnit);
  }

  double unpack(long parts) {
    return parts / perUnit;
  }

  /** Converts NaN to 0, and other numbers to 1 or more. */
  long packOptional(double number) {
    return Double.isNaN(number) ? 0 : Series.zigzag(pack(number)) + 1;
  }

  double unpackOptional(long code) {
    return code == 0 ? Double.NaN : unpack(Series.unzigzag(code - 1));
  }
}
