package org.hificamsim.core.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;

/**
 * Writes a table as CSV, row by row, without allocating objects for numbers.
 *
 * <p>Numbers are written like {@link Long#toString} and {@link Double#toString}; NaN becomes an
 * empty cell, which pandas and R read as missing. Texts are quoted if necessary, and texts that a
 * spreadsheet would take for formulas are made harmless.
 */
public final class CsvTable implements Rows {
  private final Writer out;
  private final char separator;
  private final String lineEnd;
  private final DoubleTexts doubles = new DoubleTexts();
  private final StringBuilder row = new StringBuilder();

  /**
   * Begins a table by writing its header.
   *
   * @param columns the names of the columns, with the separator between them
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
      row.append(doubles.text(number));
    }
    row.append(separator);
  }

  @Override
  public void add(String content) {
    String text = harmless(content);
    boolean plain =
        text.chars().noneMatch(letter -> letter == separator || "\"\r\n".indexOf(letter) >= 0);
    row.append(plain ? text : '"' + text.replace("\"", "\"\"") + '"').append(separator);
  }

  /** Prefixes a text that a spreadsheet would take for a formula with {@code '}. */
  public static String harmless(String text) {
    return isFormula(text, 0) && Double.isNaN(Fields.value(text)) ? "'" + text : text;
  }

  /** Restores a text that was made {@link #harmless}. */
  public static String original(String text) {
    return text.startsWith("'") && isFormula(text, 1) ? text.substring(1) : text;
  }

  private static boolean isFormula(String text, int start) {
    return text.length() > start && "=+-@\t\r".indexOf(text.charAt(start)) >= 0;
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
