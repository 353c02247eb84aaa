package org.hificamsim.reproduction;

import java.util.List;
import java.util.stream.Stream;

/** The judged cells of Table 8.1 and statements of the text. */
public record Judgement(List<Table81.Cell> cells, List<Statement> statements) {
  /** How many cells have a verdict. */
  public long cellsWith(Verdict verdict) {
    return count(cells.stream().map(Table81.Cell::verdict), verdict);
  }

  /** How many statements have a verdict. */
  public long statementsWith(Verdict verdict) {
    return count(statements.stream().map(Statement::verdict), verdict);
  }

  private static long count(Stream<Verdict> verdicts, Verdict verdict) {
    return verdicts.filter(one -> one == verdict).count();
  }
}
