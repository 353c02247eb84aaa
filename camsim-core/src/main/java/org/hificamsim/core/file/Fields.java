package org.hificamsim.core.file;

import java.util.Arrays;
import java.util.function.DoublePredicate;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** The fields of a line, which know where they stand; filled again for each line. */
public final class Fields {
  /** Blanks and tabs, any number of them. */
  public static final char BLANKS = ' ';

  private static final int MAX_QUOTED = 60;
  private static final double LARGE = 1e9;

  private final TextLines lines;
  private final char separator;
  private int[] starts = new int[16];
  private int[] ends = new int[16];
  private int count;
  private String text = "";

  /**
   * @param lines whose current line is split
   * @param separator {@link #BLANKS}, or one character between any two fields
   */
  public Fields(TextLines lines, char separator) {
    this.lines = lines;
    this.separator = separator;
  }

  /** Splits the current line; returns how many fields it has. */
  public int split() {
    text = lines.text();
    count = 0;
    int at = 0;
    while (at <= text.length()) {
      int start = afterBlanks(at);
      int end = end(start);
      if (separator != BLANKS || end > start) {
        add(start, end);
      }
      at = end + 1;
    }
    return count;
  }

  private int afterBlanks(int from) {
    int at = from;
    while (at < text.length() && isBlank(text.charAt(at)) && text.charAt(at) != separatorOrNone()) {
      at++;
    }
    return at;
  }

  private char separatorOrNone() {
    return separator == BLANKS ? 0 : separator;
  }

  private int end(int from) {
    int at = from;
    while (at < text.length() && !isSeparator(text.charAt(at))) {
      at++;
    }
    return at;
  }

  private boolean isSeparator(char c) {
    return separator == BLANKS ? isBlank(c) : c == separator;
  }

  private static boolean isBlank(char c) {
    return c == ' ' || c == '\t';
  }

  private void add(int start, int end) {
    if (count == starts.length) {
      starts = Arrays.copyOf(starts, 2 * count);
      ends = Arrays.copyOf(ends, 2 * count);
    }
    int last = end;
    while (last > start && isBlank(text.charAt(last - 1))) {
      last--;
    }
    starts[count] = start;
    ends[count++] = last;
  }

  /** How many fields the line has. */
  public int count() {
    return count;
  }

  /** A field, from 0. */
  public String text(int field) {
    return text.substring(starts[field], ends[field]);
  }

  /** Where a field begins; of one that is missing, the line's end. */
  public Place place(int field) {
    return lines.place(1 + (field < count ? starts[field] : text.length()));
  }

  /** A finite number. */
  public double number(int field, String name) {
    return number(field, name, "a finite number", value -> true);
  }

  /** A coordinate or length in metres or another unit: a number of at most 1e9 in size. */
  public double coordinate(int field, String name) {
    return number(field, name, "a number from -1e9 to 1e9", value -> Math.abs(value) <= LARGE);
  }

  /**
   * A finite number.
   *
   * @param name of the field, in error lines
   * @throws InputException when it is missing, no number, or not what is expected
   */
  public double number(int field, String name, String expected, DoublePredicate valid) {
    double value = field < count ? value(text(field)) : Double.NaN;
    if (!Double.isFinite(value) || !valid.test(value)) {
      throw invalid(field, name, expected);
    }
    return value;
  }

  /** The number that a text is; NaN where it is none, as with a suffix of Java's own. */
  public static double value(String number) {
    try {
      return isDecimal(number) ? Double.parseDouble(number) : Double.NaN;
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Whether no letter is in it but that of an exponent. */
  private static boolean isDecimal(String number) {
    for (int i = 0; i < number.length(); i++) {
      char c = number.charAt(i);
      if (c > '9' && c != 'e' && c != 'E') {
        return false;
      }
    }
    return true;
  }

  /** The fault of a field. */
  public InputException invalid(int field, String name, String expected) {
    if (field >= count) {
      return place(field).error("the line has no " + name + ", expected " + expected);
    }
    String value = text(field);
    String quoted = value.length() > MAX_QUOTED ? value.substring(0, MAX_QUOTED) + "..." : value;
    return place(field).error(name + " is '" + quoted + "', expected " + expected);
  }
}
