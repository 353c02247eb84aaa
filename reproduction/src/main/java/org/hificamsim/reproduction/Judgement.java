package org.hificamsim.reproduction;

import java.util.Collections;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The verdicts on the cells of Table 8.1 and on the statements of the text.
 *
 * @param distances the distances from our cells to the published ones, by reading
 * @param adapting the optimum's gain over a fixed zoom, by which the other results have to be read
 */
public record Judgement(
    List<Table81.Cell> cells,
    List<Distance> distances,
    List<JudgedClaim> statements,
    List<AdaptingValue> adapting) {
  /** The cells, then the statements. */
  Stream<JudgedClaim> all() {
    return Stream.concat(cells.stream().map(Table81.Cell::judged), statements.stream());
  }

  /** Returns how many cells and statements have this verdict, in words. */
  public String score(Verdict verdict) {
    return score(judged -> true, verdict);
  }

  /** Returns how many cells and statements of a role are reproduced, in words. */
  public String score(FitRole role) {
    return score(judged -> judged.role() == role, Verdict.REPRODUCED) + " reproduced";
  }

  private String score(Predicate<JudgedClaim> filter, Verdict verdict) {
    return share("cell", filter, verdict) + ", " + share("statement", filter, verdict);
  }

  private String share(String kind, Predicate<JudgedClaim> filter, Verdict verdict) {
    List<Verdict> verdicts =
        all()
            .filter(judged -> judged.kind().equals(kind))
            .filter(filter)
            .map(JudgedClaim::verdict)
            .toList();
    return "%s of %s %ss"
        .formatted(Collections.frequency(verdicts, verdict), verdicts.size(), kind);
  }
}
