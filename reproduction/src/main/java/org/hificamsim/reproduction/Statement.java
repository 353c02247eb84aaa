package org.hificamsim.reproduction;

import java.util.Comparator;
import java.util.List;
import org.hificamsim.runs.Estimate;

/**
 * Something that the text says, as checks on the runs.
 *
 * @param source section, table or figure
 * @param margins by what each must be above 0; 1 or more
 * @param remark what to know about the reading; may be empty
 */
public record Statement(
    String id, String source, String text, List<Margin> margins, String remark) {
  /** One comparison, such as a difference between two policies in one scenario. */
  public record Margin(String where, Estimate value) {}

  public Statement {
    margins = List.copyOf(margins);
  }

  /** The verdict over all margins. */
  public Verdict verdict() {
    return Verdict.of(margins.stream().map(Margin::value).toList());
  }

  /** How many margins are above 0 in the mean. */
  public long held() {
    return margins.stream().filter(margin -> margin.value().mean() > 0).count();
  }

  /** The margin that is least. */
  public Margin weakest() {
    return margins.stream()
        .min(Comparator.comparingDouble(margin -> margin.value().mean()))
        .orElseThrow();
  }
}
