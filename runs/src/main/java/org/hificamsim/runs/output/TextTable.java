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
 * A short table of texts for the terminal, or for papers as a LaTeX float in the style of the
 * package booktabs. The first columns are names, aligned left; the others are figures with
 * intervals, aligned right.
 */
public final class TextTable {
  private static final int MIN_FIGURE_CHARACTERS = 26;
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
   * Creates an empty table.
   *
   * @param names the number of first columns that are names
   * @param header the header of each column
   */
  public TextTable(int names, List<String> header) {
    this.names = names;
    this.header = header;
  }

  /** Adds a row with a cell for each column. */
  public void row(List<String> cells) {
    rows.add(cells);
  }

  /** Prints the table with columns as wide as their cells. */
  public void print(PrintWriter out) {
    List<List<String>> lines = new ArrayList<>(rows);
    List<String> titles = new ArrayList<>(header);
    titles.subList(names, titles.size()).replaceAll(title -> title + INTERVAL);
    lines.add(0, titles);
    int[] widths = new int[header.size()];
    Arrays.setAll(
        widths,
        i ->
            lines.stream()
                .mapToInt(row -> row.get(i).length())
                .reduce(i < names ? 0 : MIN_FIGURE_CHARACTERS, Math::max));
    for (List<String> row : lines) {
      List<String> cells = new ArrayList<>();
      for (int i = 0; i < widths.length; i++) {
        String format = "%" + (i < names ? "-" : "") + widths[i] + "s";
        cells.add(Texts.format(format, row.get(i)));
      }
      out.println(String.join("  ", cells).stripTrailing());
    }
  }

  /**
   * Returns the table in LaTeX, with a small space where the first name changes.
   *
   * @param label the label by which the text refers to the table
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

  /** A text escaped for LaTeX; a dash alone, which stands for no value, becomes an en dash. */
  private static String escaped(String text) {
    return text.equals("-")
        ? "--"
        : text.chars()
            .mapToObj(c -> ESCAPED.getOrDefault((char) c, String.valueOf((char) c)))
            .collect(Collectors.joining());
  }
}
