package org.hificamsim.core;

import java.util.HexFormat;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A place in a file, as error lines name it.
 *
 * @param file the file as the user named it
 * @param line from 1
 * @param column from 1, in the units that the file's reader counts
 */
public record Place(String file, int line, int column) {
  private static final Pattern LINE_ENDS = Pattern.compile("[\t-\r\\x{85}\\x{2028}\\x{2029}]+");

  /** What speaks to the terminal, or turns the order of what follows (Unicode's UAX 9, 2). */
  private static final Pattern UNPRINTABLE =
      Pattern.compile(
          "[\\p{Cntrl}\\x{80}-\\x{9f}\\x{61c}\\x{200e}\\x{200f}\\x{202a}-\\x{202e}\\x{2066}-\\x{2069}&&[^\n\r"
              + "\t]]");

  private static final HexFormat HEX = HexFormat.of().withUpperCase();
  private static final int MAX_PROBLEM = 500;
  private static final int MAX_VALUE = 60;

  /** The fault {@code FILE:LINE:COLUMN: problem}, in one short line whatever the texts hold. */
  public InputException error(String problem) {
    return new InputException(line(problem));
  }

  /** The same, with values in the form of {@link Texts#format}. */
  public InputException error(String form, Object... values) {
    return error(Texts.format(form, values));
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
    return printable(this + ": " + fitting(problem));
  }

  /** The start of a long problem, and what was expected instead. */
  private static String fitting(String problem) {
    int expected = problem.lastIndexOf(", expected ");
    boolean kept = expected >= 0 && problem.length() - expected < MAX_PROBLEM / 2;
    String end = kept ? problem.substring(expected) : "";
    return problem.length() <= MAX_PROBLEM
        ? problem
        : problem.substring(0, MAX_PROBLEM - end.length()) + "..." + end;
  }

  /** A text as one line that is read as it is written. */
  public static String printable(String text) {
    return escaped(LINE_ENDS.matcher(text).replaceAll(" "), "\\");
  }

  /**
   * A text whose control characters and marks of direction are shown as <code>&#92;u202E</code>.
   *
   * @param backslash as it is to be written
   */
  public static String escaped(String text, String backslash) {
    return UNPRINTABLE
        .matcher(text)
        .replaceAll(
            odd ->
                Matcher.quoteReplacement(backslash + "u" + HEX.toHexDigits(odd.group().charAt(0))));
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
