package org.hificamsim.core.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;

/**
 * A table as text, row by row; no object is made for a number.
 *
 * <p>Numbers are written as {@link Long#toString} and {@link Double#toString} write them; NaN is an
 * empty cell, which pandas and R read as missing. Texts are quoted where they have to be, and
 * formulas made harmless.
 */
public final class CsvTable implements Rows {
  private final Writer out;
  private final char separator;
  private final String lineEnd;
  private final StringBuilder row = new StringBuilder();

  /**
   * Writes the header.
   *
   * @param columns their names, separated as the cells will be
   */
  public CsvTable(Writer out, String columns, char separator, String lineEnd) throws IOException {
    this.out = out;
    this.separator = separator;
    this.lineEnd = lineEnd;
    out.append(columns).append(lineEnd);
  }

  @Override
  public void add(long number) {
    row.append(number).append(separator);
  }

  @Override
  public void add(double number) {
    if (!Double.isNaN(number)) {
      row.append(number);
    }
    row.append(separator);
  }

  @Override
  public void add(String content) {
    String text = harmless(content);
    boolean plain = text.chars().noneMatch(c -> c == separator || "\"\r\n".indexOf(c) >= 0);
    row.append(plain ? text : '"' + text.replace("\"", "\"\"") + '"').append(separator);
  }

  /**
   * A text that no spreadsheet takes for a formula: with a {@code '} before what begins like one.
   */
  public static String harmless(String text) {
    return isFormula(text, 0) && Double.isNaN(Fields.value(text)) ? "'" + text : text;
  }

  /** The text that was made {@link #harmless}. */
  public static String original(String text) {
    return text.startsWith("'") && isFormula(text, 1) ? text.substring(1) : text;
  }

  private static boolean isFormula(String text, int at) {
    return text.length() > at && "=+-@\t\r".indexOf(text.charAt(at)) >= 0;
  }

  @Override
  public void end() {
    row.setLength(row.length() - 1);
    try {
      out.append(row.append(lineEnd));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    row.setLength(0);
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
