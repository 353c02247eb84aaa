package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.junit.jupiter.api.Test;

class TextTableTest {
  @Test
  void escapesSpecialCharactersOfLatex() {
    TextTable table = new TextTable(1, List.of("a"));
    table.row(List.of("a_b&c%$#{}~^\\"));
    table.row(List.of("-"));
    String text = table.latex("", "");
    assertTrue(
        text.contains(
            "a\\_b\\&c\\%\\$\\#\\{\\}\\textasciitilde{}\\textasciicircum{}\\textbackslash{} "));
    assertTrue(text.contains("\n-- "), text);
  }

  @Test
  void alignsColumnsOnTheTerminal() {
    TextTable table = new TextTable(1, List.of("name", "figure"));
    table.row(List.of("a", "1.5 [1.0, 2.0]"));
    StringWriter out = new StringWriter();
    table.print(new PrintWriter(out));
    assertEquals(
        List.of("name                figure [95%]", "a                 1.5 [1.0, 2.0]"),
        out.toString().lines().toList());
  }

  @Test
  void writesBooktabsFloat() {
    TextTable textTable = new TextTable(1, List.of("a", "of b"));
    textTable.row(List.of("one", "1 [0, 2]"));
    textTable.row(List.of("one", "2"));
    textTable.row(List.of("two", "3"));
    String table = textTable.latex("95% of k_min", "tab:x");
    assertEquals(
        List.of(
            "\\begin{table}",
            "\\centering",
            "\\caption{95\\% of k\\_min}",
            "\\label{tab:x}",
            "\\begin{tabular}{lr}",
            "\\toprule",
            "A & Of b \\\\",
            "\\midrule",
            "one & 1 [0, 2] \\\\",
            "one & 2 \\\\",
            "\\addlinespace",
            "two & 3 \\\\",
            "\\bottomrule",
            "\\end{tabular}",
            "\\end{table}"),
        table.lines().toList());
    assertTrue(table.endsWith("\n"));
  }
}
