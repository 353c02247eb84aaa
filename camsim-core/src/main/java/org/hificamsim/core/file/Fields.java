package org.hificamsim.core.file;

import java.util.function.DoublePredicate;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** The fields of a line or of a table's row, which know where they stand. */
public interface Fields {
  /** How many there are. */
  int count();

  /** A field, from 0. */
  String text(int field);

  /** Where a field begins; of one that is missing, the end. */
  Place place(int field);

  /** The number that a field is; NaN where it is none. */
  default double value(int field) {
    return value(text(field));
  }

  /** A finite number. */
  default double number(int field, String name) {
    return number(field, name, "a finite number", value -> true);
  }

  /** A coordinate or length in metres or another unit: a number of at most 1e9 in size. */
  default double coordinate(int field, String name) {
    return number(field, name, "a number from -1e9 to 1e9", value -> Math.abs(value) <= 1e9);
  }

  /**
   * A finite number.
   *
   * @param name of the field, in error lines
   * @throws InputException when it is missing, no number, or not what is expected
   */
  default double number(int field, String name, String expected, DoublePredicate valid) {
    double value = field < count() ? value(field) : Double.NaN;
    if (!Double.isFinite(value) || !valid.test(value)) {
      throw invalid(field, name, expected);
    }
    return value;
  }

  /** The fault of a field. */
  default InputException invalid(int field, String name, String expected) {
    if (field >= count()) {
      return place(field).error("the line has no " + name + ", expected " + expected);
    }
    return place(field).invalid(name, text(field), expected);
  }

  /** The number that a text is; NaN where it is none, as with a suffix of Java's own. */
  static double value(String number) {
    for (int i = 0; i < number.length(); i++) {
      char c = number.charAt(i);
      if (c > '9' && c != 'e' && c != 'E') {
        return Double.NaN;
      }
    }
    try {
      return Double.parseDouble(number);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }
}
