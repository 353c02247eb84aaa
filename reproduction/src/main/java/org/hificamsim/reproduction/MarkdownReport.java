package org.hificamsim.reproduction;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.hificamsim.core.file.OutputFolder;

/** Table and verdicts for people: {@code table-8.1.md} and {@code verdicts.md}. */
final class MarkdownReport {
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
            + " the same at 0.45 | explore=any | script at origin |");
    line("|---|---|---|---:|---:|---|---:|---:|---:|---:|");
    for (Table81.Cell cell : cells) {
      line(
          "| %s | %s | %s | %.2f | %.3f [%.3f, %.3f] | %s | %s | %s | %s | %s |",
          cell.published().layout().label(),
          cell.published().policy(),
          cell.published().hifi() ? "hi-fi" : "CamSim",
          cell.published().proportion(),
          cell.ours().mean(),
          cell.ours().low(),
          cell.ours().high(),
          cell.verdict().label(),
          number(cell.overHifi()),
          number(cell.at45()),
          number(cell.exploreAny()),
          number(cell.origin()));
    }
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.2f", value);
  }

  private void verdicts(Judgement judgement) {
    line("| cell | published | ours | verdict | why |");
    line("|---|---:|---:|---|---|");
    for (Table81.Cell cell : judgement.cells()) {
      line(
          "| %s | %.2f | %.2f | %s | %s |",
          Reason.id(cell),
          cell.published().proportion(),
          cell.ours().mean(),
          cell.verdict().label(),
          Reason.of(cell));
    }
    line("");
    line("| statement | source | verdict | why |");
    line("|---|---|---|---|");
    for (Statement statement : judgement.statements()) {
      line(
          "| %s | %s | %s | %s |",
          statement.text(), statement.source(), statement.verdict().label(), Reason.of(statement));
    }
  }

  private void line(String pattern, Object... values) {
    out.print(values.length == 0 ? pattern : String.format(Locale.ROOT, pattern, values));
    out.print('\n');
  }
}
