package org.hificamsim.core.file;

import java.util.function.DoublePredicate;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** The fields of a line or of a table's row, with their places in the file. */
public interface Fields {
  /** The number of fields. */
  int count();

  /** The text of a field, counted from 0. */
  String text(int field);

  /** The place where a field begins; the end of the line for a missing field. */
  Place place(int field);

  /** The number in a field; NaN if it is not a number. */
  default double value(int field) {
    return value(text(field));
  }

  /** Reads a finite number. */
  default double number(int field, String name) {
    return number(field, name, "a finite number", value -> true);
  }

  /** Reads a coordinate or length: a number from -1e9 to 1e9. */
  default double coordinate(int field, String name) {
    return number(field, name, "a number from -1e9 to 1e9", value -> Math.abs(value) <= 1e9);
  }

  /**
   * Reads a finite number.
   *
   * @param name the name of the field, for messages
   * @throws InputException if the field is missing, not a number, or not valid
   */
  default double number(int field, String name, String expected, DoublePredicate valid) {
    double value = field < count() ? value(field) : Double.NaN;
    if (!Double.isFinite(value) || !valid.test(value)) {
      boolean isGrouped = field < count() && isGrouped(text(field));
      throw invalid(
          field, name, isGrouped ? expected + " without separators of thousands" : expected);
    }
    return value;
  }

  /** The error about an invalid or missing field. */
  default InputException invalid(int field, String name, String expected) {
    if (field >= count()) {
      return place(field).error("the line has no " + name + ", expected " + expected);
    }
    return place(field).invalid(name, text(field), expected);
  }

  /** Whether a text is a number whose thousands are separated, such as 1,234.5 or 1 234,5. */
  static boolean isGrouped(String text) {
    return text.matches("[+-]?\\d{1,3}([.,'\u2019 \u00a0\u202f]\\d{3})+([.,]\\d+)?");
  }

  /** Parses a number; returns NaN for other texts, including numbers with a suffix of Java's. */
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
