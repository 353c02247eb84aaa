package org.hificamsim.runs.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** A table for papers: a LaTeX float in the style of the package booktabs. */
public final class LatexTable {
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

  private final String caption;
  private final String label;
  private final int names;
  private final List<String> header;
  private final List<String> lines = new ArrayList<>();
  private String last = "";

  /**
   * An empty table.
   *
   * @param label that the text refers to it by
   * @param names how many of the columns, the first ones, are names; the rest are set to the right
   * @param header of each column
   */
  public LatexTable(String caption, String label, int names, String... header) {
    this.caption = caption;
    this.label = label;
    this.names = names;
    this.header = List.of(header);
  }

  /** Adds a row of texts as they are; where the first one changes, there is a little space. */
  public LatexTable row(String... cells) {
    if (!last.isEmpty() && !last.equals(cells[0])) {
      lines.add("\\addlinespace");
    }
    last = cells[0];
    lines.add(line(Arrays.asList(cells)));
    return this;
  }

  private static String line(List<String> cells) {
    return cells.stream().map(LatexTable::escaped).collect(Collectors.joining(" & ")) + " \\\\";
  }

  /** A text that LaTeX prints as it is. */
  static String escaped(String text) {
    return text.chars()
        .mapToObj(c -> ESCAPED.getOrDefault((char) c, String.valueOf((char) c)))
        .collect(Collectors.joining());
  }

  /** The float. */
  public String text() {
    List<String> all = new ArrayList<>();
    all.add("\\begin{table}");
    all.add("\\centering");
    all.add("\\caption{" + escaped(caption) + "}");
    all.add("\\label{" + label + "}");
    all.add("\\begin{tabular}{" + "l".repeat(names) + "r".repeat(header.size() - names) + "}");
    all.add("\\toprule");
    all.add(line(header));
    all.add("\\midrule");
    all.addAll(lines);
    all.add("\\bottomrule");
    all.add("\\end{tabular}");
    all.add("\\end{table}");
    return String.join("\n", all) + "\n";
  }
}
