package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A table on the terminal: names to the left of their columns, figures to the right. */
final class Columns {
  private static final int FIGURE = 26;

  private final int names;
  private final List<List<String>> rows = new ArrayList<>();

  /**
   * @param names how many of the columns, the first ones, are names
   */
  Columns(int names) {
    this.names = names;
  }

  /** Adds a row, the header first. */
  void add(String... cells) {
    rows.add(new ArrayList<>(List.of(cells)));
  }

  /** Adds a cell to the row that was added last. */
  void addToRow(String cell) {
    rows.get(rows.size() - 1).add(cell);
  }

  void print(PrintWriter out) {
    int[] widths = new int[rows.get(0).size()];
    for (int i = 0; i < widths.length; i++) {
      int column = i;
      int least = i < names ? 0 : FIGURE;
      widths[i] = rows.stream().mapToInt(row -> row.get(column).length()).reduce(least, Math::max);
    }
    rows.forEach(row -> print(out, row, widths));
  }

  private void print(PrintWriter out, List<String> row, int[] widths) {
    List<String> cells = new ArrayList<>();
    for (int i = 0; i < widths.length; i++) {
      cells.add(
          String.format(Locale.ROOT, "%" + (i < names ? "-" : "") + widths[i] + "s", row.get(i)));
    }
    out.println(String.join("  ", cells));
  }
}
