package org.hificamsim.reproduction;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.hificamsim.core.file.OutputFolder;

/** Table and verdicts for people: {@code table-8.1.md} and {@code verdicts.md}. */
final class MarkdownReport {
  /** Why CamSim's formula is not the one behind Table 8.1. */
  private static final String PROOF =
      "Eq 6.2 depends on the zoom alone, so that a camera detects either all or nothing within the"
          + " radius of a level. Where the widest level detects, its targets are those of every"
          + " level, and zoom-out is the optimum: 1. Where it does not, zoom-out covers nothing: 0."
          + " No threshold gives the published 0.18, 0.58 and 0.05; hence camsim-range.";

  private final PrintWriter out;

  private MarkdownReport(PrintWriter out) {
    this.out = out;
  }

  static void write(OutputFolder folder, Judgement judgement) throws IOException {
    try (PrintWriter out = new PrintWriter(folder.open("table-8.1.md"))) {
      new MarkdownReport(out).table(judgement.cells());
    }
    try (PrintWriter out = new PrintWriter(folder.open("verdicts.md"))) {
      new MarkdownReport(out).verdicts(judgement);
    }
  }

  private void table(List<Table81.Cell> cells) {
    line(
        "| layout | policy | detection | published | ours [95%] | verdict | over hi-fi optimum |"
            + " the same at 0.45 | explore=any | script at origin | Eq 6.2 | role |");
    line("|---|---|---|---:|---:|---|---:|---:|---:|---:|---:|---|");
    for (Table81.Cell cell : cells) {
      line(
          "| %s | %s | %s | %.2f | %s | %s | %s | %s | %s | %s | %s | %s |",
          cell.published().layout().label(),
          cell.published().policy(),
          cell.published().hifi() ? "hi-fi" : "CamSim",
          cell.published().proportion(),
          cell.ours().text("%.3f"),
          cell.verdict().label(),
          number(cell.overHifi()),
          number(cell.at45()),
          number(cell.exploreAny()),
          number(cell.origin()),
          number(cell.standard()),
          cell.role().label());
    }
    line("");
    line("%s", PROOF);
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.2f", value);
  }

  private void verdicts(Judgement judgement) {
    line("%s", Adapting.finding(judgement.adapting()));
    line("");
    for (FitRole role : FitRole.values()) {
      line("- %s: %s", role.label(), judgement.score(role));
    }
    line("");
    line("| cell | role | published | ours | verdict | why |");
    line("|---|---|---:|---:|---|---|");
    for (Table81.Cell cell : judgement.cells()) {
      line(
          "| %s | %s | %.2f | %.2f | %s | %s |",
          cell.id(),
          cell.role().label(),
          cell.published().proportion(),
          cell.ours().mean(),
          cell.verdict().label(),
          cell.reason());
    }
    line("");
    line("| statement | source | role | verdict | why |");
    line("|---|---|---|---|---|");
    for (Statement statement : judgement.statements()) {
      line(
          "| %s | %s | %s | %s | %s |",
          statement.text(),
          statement.source(),
          statement.role().label(),
          statement.verdict().label(),
          statement.reason());
    }
  }

  private void line(String pattern, Object... values) {
    out.print(values.length == 0 ? pattern : String.format(Locale.ROOT, pattern, values));
    out.print('\n');
  }
}
