package org.hificamsim.reproduction;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * The judged cells of Table 8.1 and statements of the text.
 *
 * @param adapting what the optimum gains over a fixed zoom, which comes before all else
 */
public record Judgement(
    List<Table81.Cell> cells, List<Statement> statements, List<Adapting> adapting) {
  /** How many cells have a verdict. */
  public long cellsWith(Verdict verdict) {
    return count(cells.stream().map(Table81.Cell::verdict), verdict);
  }

  /** How many statements have a verdict. */
  public long statementsWith(Verdict verdict) {
    return count(statements.stream().map(Statement::verdict), verdict);
  }

  /** How many cells and statements of a role there are, and how many of them are reproduced. */
  public String score(FitRole role) {
    List<Verdict> ofCells = verdictsOfCells(role);
    List<Verdict> ofStatements = verdictsOfStatements(role);
    return String.format(
        Locale.ROOT,
        "%d of %d cells, %d of %d statements reproduced",
        count(ofCells.stream(), Verdict.REPRODUCED),
        ofCells.size(),
        count(ofStatements.stream(), Verdict.REPRODUCED),
        ofStatements.size());
  }

  private List<Verdict> verdictsOfCells(FitRole role) {
    return cells.stream()
        .filter(cell -> FitRole.of(cell) == role)
        .map(Table81.Cell::verdict)
        .toList();
  }

  private List<Verdict> verdictsOfStatements(FitRole role) {
    return statements.stream()
        .filter(statement -> FitRole.of(statement) == role)
        .map(Statement::verdict)
        .toList();
  }

  private static long count(Stream<Verdict> verdicts, Verdict verdict) {
    return verdicts.filter(one -> one == verdict).count();
  }
}
