package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class LatexTableTest {
  @Test
  void escapesWhatMeansSomethingToLatex() {
    assertEquals(
        "a\\_b\\&c\\%\\$\\#\\{\\}\\textasciitilde{}\\textasciicircum{}\\textbackslash{}",
        LatexTable.escaped("a_b&c%$#{}~^\\"));
  }

  @Test
  void isABooktabsFloat() {
    String table =
        new LatexTable("95% of k_min", "tab:x", 1, "A", "B")
            .row("one", "1 [0, 2]")
            .row("one", "2")
            .row("two", "3")
            .text();
    assertEquals(
        List.of(
            "\\begin{table}",
            "\\centering",
            "\\caption{95\\% of k\\_min}",
            "\\label{tab:x}",
            "\\begin{tabular}{lr}",
            "\\toprule",
            "A & B \\\\",
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
