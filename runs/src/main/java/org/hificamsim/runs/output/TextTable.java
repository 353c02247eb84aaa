package org.hificamsim.runs.output;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.hificamsim.core.Texts;

/**
 * A short table of texts for people: on the terminal, or for papers as a LaTeX float in the style
 * of the package booktabs. The first columns are names, to the left; the others are figures with
 * intervals, to the right.
 */
public final class TextTable {
  private static final int FIGURE = 26;
  private static final String INTERVAL = " [95%]";
  private static final Map<Character, String> ESCAPED =
      Map.of(
          '&', "\\&",
          '%', "\\%",
          '$', "\\$",
          '#', "\\#",
          '_', "\\_",
          '{', "\\{",
          '}', "\\}",
          '~', "\\textasciitilde{}",
          '^', "\\textasciicircum{}",
          '\\', "\\textbackslash{}");

  private final int names;
  private final List<String> header;
  private final List<List<String>> rows = new ArrayList<>();

  /**
   * An empty table.
   *
   * @param names how many of the columns, the first ones, are names
   * @param header of each column
   */
  public TextTable(int names, List<String> header) {
    this.names = names;
    this.header = header;
  }

  /** Adds a row, a cell for each column. */
  public void row(List<String> cells) {
    rows.add(cells);
  }

  /** Prints the table, its columns as wide as their cells. */
  public void print(PrintWriter out) {
    List<List<String>> all = new ArrayList<>(rows);
    List<String> titles = new ArrayList<>(header);
    titles.subList(names, titles.size()).replaceAll(title -> title + INTERVAL);
    all.add(0, titles);
    int[] widths = new int[header.size()];
    Arrays.setAll(
        widths,
        i ->
            all.stream()
                .mapToInt(row -> row.get(i).length())
                .reduce(i < names ? 0 : FIGURE, Math::max));
    for (List<String> row : all) {
      List<String> cells = new ArrayList<>();
      for (int i = 0; i < widths.length; i++) {
        String format = "%" + (i < names ? "-" : "") + widths[i] + "s";
        cells.add(Texts.format(format, row.get(i)));
      }
      out.println(String.join("  ", cells));
    }
  }

  /**
   * The table for LaTeX; where the first name changes, there is a little space.
   *
   * @param label that the text refers to it by
   */
  public String latex(String caption, String label) {
    List<String> lines = new ArrayList<>();
    lines.add("\\begin{table}");
    lines.add("\\centering");
    lines.add("\\caption{" + escaped(caption) + "}");
    lines.add("\\label{" + label + "}");
    lines.add("\\begin{tabular}{" + "l".repeat(names) + "r".repeat(header.size() - names) + "}");
    lines.add("\\toprule");
    lines.add(line(header.stream().map(TextTable::capitalized).toList()));
    lines.add("\\midrule");
    String last = "";
    for (List<String> row : rows) {
      if (!last.isEmpty() && !last.equals(row.get(0))) {
        lines.add("\\addlinespace");
      }
      last = row.get(0);
      lines.add(line(row));
    }
    lines.add("\\bottomrule");
    lines.add("\\end{tabular}");
    lines.add("\\end{table}");
    return String.join("\n", lines) + "\n";
  }

  private static String capitalized(String title) {
    return title.substring(0, 1).toUpperCase(Locale.ROOT) + title.substring(1);
  }

  private static String line(List<String> cells) {
    return cells.stream().map(TextTable::escaped).collect(Collectors.joining(" & ")) + " \\\\";
  }

  /** A text that LaTeX prints as it is; a dash alone, for no value, is a longer one. */
  private static String escaped(String text) {
    return text.equals("-")
        ? "--"
        : text.chars()
            .mapToObj(c -> ESCAPED.getOrDefault((char) c, String.valueOf((char) c)))
            .collect(Collectors.joining());
  }
}
