package org.hificamsim.core;

import java.util.HexFormat;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A position in a file, as messages name it.
 *
 * @param file the file as the user named it
 * @param line the number of the line, from 1
 * @param column the number of the column, from 1, in the units that the file's reader counts
 */
public record Place(String file, int line, int column) {
  private static final Pattern LINE_ENDS = Pattern.compile("[\t-\r\\x{85}\\x{2028}\\x{2029}]+");

  /** Characters that control the terminal or the direction of text (Unicode UAX 9, 2). */
  private static final Pattern UNPRINTABLE =
      Pattern.compile(
          "[\\p{Cntrl}\\x{80}-\\x{9f}\\x{61c}\\x{200e}\\x{200f}\\x{202a}-\\x{202e}\\x{2066}-\\x{2069}&&[^\n\r"
              + "\t]]");

  private static final HexFormat HEX = HexFormat.of().withUpperCase();
  private static final int MAX_PROBLEM = 500;
  private static final int MAX_VALUE = 60;

  /** Creates the error {@code FILE:LINE:COLUMN: problem} in one short line. */
  public InputException error(String problem) {
    return new InputException(line(problem));
  }

  /** Creates the error of a message with values, as in {@link Texts#format}. */
  public InputException error(String form, Object... values) {
    return error(Texts.format(form, values));
  }

  /** Creates the error {@code FILE:LINE:COLUMN: name is 'value', expected ...}. */
  public InputException invalid(String name, String value, String expected) {
    return error(name + " is '" + shortened(value) + "', expected " + expected);
  }

  /** Shortens a long value for messages to its start. */
  public static String shortened(String value) {
    return value.length() > MAX_VALUE ? value.substring(0, MAX_VALUE) + "..." : value;
  }

  /** The line {@code FILE:LINE:COLUMN: problem}. */
  public String line(String problem) {
    return printable(this + ": " + fitting(problem));
  }

  /** Shortens a long problem to its start and what was expected instead. */
  private static String fitting(String problem) {
    int expected = problem.lastIndexOf(", expected ");
    boolean kept = expected >= 0 && problem.length() - expected < MAX_PROBLEM / 2;
    String end = kept ? problem.substring(expected) : "";
    return problem.length() <= MAX_PROBLEM
        ? problem
        : problem.substring(0, MAX_PROBLEM - end.length()) + "..." + end;
  }

  /** Returns a text as one line without unprintable characters. */
  public static String printable(String text) {
    return escaped(LINE_ENDS.matcher(text).replaceAll(" "), "\\");
  }

  /**
   * Replaces control characters and direction marks by escapes such as <code>&#92;u202E</code>.
   *
   * @param backslash the text for the backslash of an escape
   */
  public static String escaped(String text, String backslash) {
    return UNPRINTABLE
        .matcher(text)
        .replaceAll(
            unprintable ->
                Matcher.quoteReplacement(
                    backslash + "u" + HEX.toHexDigits(unprintable.group().charAt(0))));
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
