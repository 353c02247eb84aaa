package org.hificamsim.presentation.replay;

import org.hificamsim.core.scenario.spec.Field;

/**
 * Numbers as whole multiples of a power of ten, so that they are few bytes and decimals stay exact.
 *
 * @param perUnit how many parts a unit has
 */
record Scale(double perUnit) {
  private static final double SMALLEST = 1e-6;

  /** Millimetres; finer in a field below 10 m, coarser where numbers would not fit. */
  static Scale of(Field field) {
    double magnitude = magnitude(Math.max(field.width(), field.height()));
    return new Scale(Math.pow(10, Math.min(Math.max(3, 4 - magnitude), 12 - magnitude)));
  }

  /** Five digits for the largest number. */
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

  /** As {@link #pack} with 0 for NaN, other numbers from 1. */
  long packOptional(double number) {
    return Double.isNaN(number) ? 0 : Series.zigzag(pack(number)) + 1;
  }

  double unpackOptional(long code) {
    return code == 0 ? Double.NaN : unpack(Series.unzigzag(code - 1));
  }
}
