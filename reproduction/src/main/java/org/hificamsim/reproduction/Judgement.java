package org.hificamsim.reproduction;

import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;

/**
 * The judged cells of Table 8.1 and statements of the text.
 *
 * @param adapting what the optimum gains over a fixed zoom, which comes before all else
 */
public record Judgement(
    List<Table81.Cell> cells, List<Statement> statements, List<Adapting> adapting) {
  /** How many cells and statements have a verdict. */
  public String score(Verdict verdict) {
    return score(one -> true, verdict);
  }

  /** How many cells and statements of a role there are, and how many of them are reproduced. */
  public String score(FitRole role) {
    return score(one -> one.role() == role, Verdict.REPRODUCED) + " reproduced";
  }

  private String score(Predicate<Judged> which, Verdict verdict) {
    return share(cells, which, verdict)
        + " cells, "
        + share(statements, which, verdict)
        + " statements";
  }

  private static String share(
      List<? extends Judged> all, Predicate<Judged> which, Verdict verdict) {
    List<Verdict> verdicts = all.stream().filter(which).map(Judged::verdict).toList();
    return Collections.frequency(verdicts, verdict) + " of " + verdicts.size();
  }
}
