package org.hificamsim.reproduction;

import java.util.Comparator;
import java.util.List;
import java.util.Set;
import org.hificamsim.runs.Estimate;

/**
 * Something that the text says, as checks on the runs.
 *
 * @param source section, table or figure
 * @param margins by what each must be above 0; 1 or more
 * @param remark what to know about the reading; may be empty
 */
public record Statement(String id, String source, String text, List<Margin> margins, String remark)
    implements Judged {
  /** Statements that Table 8.1's hi-fi column implies, at least in part, by their ids. */
  private static final Set<String> IMPLIED =
      Set.of(
          "baselines-below-greedy",
          "order-of-policies",
          "epsilon-greedy-above-zoom-out",
          "learning-pays",
          "zoom-out-not-optimal",
          "camsim-underestimates");

  /** One comparison, such as a difference between two policies in one scenario. */
  public record Margin(String where, Estimate value) {}

  public Statement {
    margins = List.copyOf(margins);
  }

  @Override
  public Estimate value() {
    return weakest().value();
  }

  @Override
  public int checks() {
    return margins.size();
  }

  /** How many margins are above 0 in the mean. */
  @Override
  public int held() {
    return (int) margins.stream().filter(margin -> margin.value().mean() > 0).count();
  }

  /** The verdict over all margins. */
  @Override
  public Verdict verdict() {
    return Verdict.of(margins.stream().map(Margin::value).toList());
  }

  @Override
  public String reason() {
    String margin = weakest().where() + " " + value().text("%+.3f");
    String all = Judged.format("%d of %d checks hold; weakest: %s", held(), checks(), margin);
    return remark.isEmpty() ? all : all + "; " + remark;
  }

  @Override
  public FitRole role() {
    return IMPLIED.contains(id) ? FitRole.FITTED : FitRole.HELD_OUT;
  }

  /** The margin that is least. */
  private Margin weakest() {
    return margins.stream()
        .min(Comparator.comparingDouble(margin -> margin.value().mean()))
        .orElseThrow();
  }
}
