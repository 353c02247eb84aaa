package org.hificamsim.core;

import java.util.regex.Pattern;

/**
 * A place in a file, as error lines name it.
 *
 * @param file the file as the user named it
 * @param line from 1
 * @param column from 1, in the units that the file's reader counts
 */
public record Place(String file, int line, int column) {
  private static final Pattern UNPRINTABLE =
      Pattern.compile("[\\p{Cntrl}\\x{80}-\\x{9f}\\x{2028}\\x{2029}]+");
  private static final int MAX_PROBLEM = 500;
  private static final int MAX_VALUE = 60;

  /** The fault {@code FILE:LINE:COLUMN: problem}, in one short line whatever the texts hold. */
  public InputException error(String problem) {
    return new InputException(line(problem));
  }

  /** The fault {@code FILE:LINE:COLUMN: name is 'value', expected ...}. */
  public InputException invalid(String name, String value, String expected) {
    return error(name + " is '" + shortened(value) + "', expected " + expected);
  }

  /** A value as error lines show it: its start alone where it is long. */
  public static String shortened(String value) {
    return value.length() > MAX_VALUE ? value.substring(0, MAX_VALUE) + "..." : value;
  }

  /** The line {@code FILE:LINE:COLUMN: problem}. */
  public String line(String problem) {
    String shortened =
        problem.length() <= MAX_PROBLEM ? problem : problem.substring(0, MAX_PROBLEM) + "...";
    return printable(this + ": " + shortened);
  }

  /** A text as one line without control characters, which could speak to the terminal. */
  public static String printable(String text) {
    return UNPRINTABLE.matcher(text).replaceAll(" ");
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
