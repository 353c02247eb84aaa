package org.hificamsim.reproduction;

import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.hificamsim.runs.Estimate;

/**
 * The judged cells of Table 8.1 and statements of the text.
 *
 * @param distances of the cells from the published ones, by reading
 * @param adapting what the optimum gains over a fixed zoom, which comes before all else
 */
public record Judgement(
    List<Table81.Cell> cells,
    List<Distance> distances,
    List<Judged> statements,
    List<Adapting> adapting) {
  /** The cells, then the statements. */
  Stream<Judged> all() {
    return Stream.concat(cells.stream().map(Table81.Cell::judged), statements.stream());
  }

  /** How many cells and statements have a verdict. */
  public String score(Verdict verdict) {
    return score(one -> true, verdict);
  }

  /** How many cells and statements of a role there are, and how many of them are reproduced. */
  public String score(FitRole role) {
    return score(one -> one.role() == role, Verdict.REPRODUCED) + " reproduced";
  }

  private String score(Predicate<Judged> which, Verdict verdict) {
    return share("cell", which, verdict) + ", " + share("statement", which, verdict);
  }

  private String share(String kind, Predicate<Judged> which, Verdict verdict) {
    List<Verdict> verdicts =
        all().filter(one -> one.kind().equals(kind)).filter(which).map(Judged::verdict).toList();
    return "%s of %s %ss"
        .formatted(Collections.frequency(verdicts, verdict), verdicts.size(), kind);
  }

  /**
   * A cell of Table 8.1 or a statement of the text, compared with what we find: a row of {@code
   * verdicts.csv}.
   *
   * @param kind {@code cell} or {@code statement}
   * @param source section, table or figure of the thesis
   * @param text what it says
   * @param published a cell's; NaN for a statement
   * @param value a cell's proportion; a statement's weakest margin
   * @param checks how many comparisons decide it
   * @param held how many of them hold
   * @param reason for the verdict, in one line
   * @param role whether the defaults were chosen for it
   */
  public record Judged(
      String kind,
      String id,
      String source,
      String text,
      double published,
      Estimate value,
      int checks,
      int held,
      Verdict verdict,
      String reason,
      FitRole role) {}
}
