package org.hificamsim.reproduction;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.Table;

/** The files of a reproduction: table and verdicts as CSV and Markdown, and the figures. */
public final class ReproductionFiles {
  private ReproductionFiles() {}

  /**
   * Writes all files.
   *
   * @return the judged table and statements
   */
  public static Judgement write(OutputFolder folder, List<CaseResult> results) throws IOException {
    Cases cases = new Cases(results);
    Judgement judgement = judge(cases);
    adapting(folder, judgement.adapting());
    table(folder, judgement.cells());
    verdicts(folder, judgement);
    MarkdownReport.write(folder, judgement);
    new ReproductionFigures(cases).write(folder);
    return judgement;
  }

  /** The table and all statements. */
  public static Judgement judge(Cases cases) {
    List<Statement> statements = new ArrayList<>(new Statements(cases).all());
    statements.addAll(new DetectionStatements(cases).all());
    return new Judgement(new Table81(cases).cells(), statements, Adapting.of(cases));
  }

  private static void adapting(OutputFolder folder, List<Adapting> all) throws IOException {
    try (CsvTable table = Table.ADAPTING.create(folder)) {
      for (Adapting one : all) {
        table.row(
            one.scenario(),
            one.detection(),
            one.optimum(),
            one.fixed(),
            one.value(),
            one.sameEveryStep() ? "true" : "false");
      }
    }
  }

  private static void table(OutputFolder folder, List<Table81.Cell> cells) throws IOException {
    try (CsvTable table = Table.TABLE_8_1.create(folder)) {
      for (Table81.Cell cell : cells) {
        table.row(
            cell.published().layout().label(),
            cell.published().policy(),
            cell.published().detection(),
            cell.published().proportion(),
            cell.ours().mean(),
            cell.ours().low(),
            cell.ours().high(),
            cell.difference(),
            cell.verdict().label(),
            cell.overHifi(),
            cell.at45(),
            cell.exploreAny(),
            cell.origin(),
            cell.standard(),
            FitRole.of(cell).label());
      }
    }
  }

  private static void verdicts(OutputFolder folder, Judgement judgement) throws IOException {
    try (CsvTable table = Table.VERDICTS.create(folder)) {
      for (Table81.Cell cell : judgement.cells()) {
        table.row(
            "cell",
            Reason.id(cell),
            "Table 8.1",
            "proportion of the optimum",
            cell.published().proportion(),
            cell.ours().mean(),
            cell.ours().low(),
            cell.ours().high(),
            1,
            cell.verdict() == Verdict.REPRODUCED ? 1 : 0,
            cell.verdict().label(),
            Reason.of(cell),
            FitRole.of(cell).label());
      }
      for (Statement statement : judgement.statements()) {
        Statement.Margin weakest = statement.weakest();
        table.row(
            "statement",
            statement.id(),
            statement.source(),
            statement.text(),
            "",
            weakest.value().mean(),
            weakest.value().low(),
            weakest.value().high(),
            statement.margins().size(),
            statement.held(),
            statement.verdict().label(),
            Reason.of(statement),
            FitRole.of(statement).label());
      }
    }
  }
}
