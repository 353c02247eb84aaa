package org.hificamsim.cli;

import java.util.function.Consumer;
import org.hificamsim.core.Texts;
import org.hificamsim.placement.site.PlacementProblem;

/** Prints the progress of a search for a plan: its parts, and each change of score and bound. */
final class SearchProgress implements PlacementProblem.Watcher {
  private final Consumer<String> notes;
  private final boolean asShares;
  private String last = "";

  /**
   * @param notes prints a line
   * @param asShares whether scores are shares of the demand
   */
  SearchProgress(Consumer<String> notes, boolean asShares) {
    this.notes = notes;
    this.asShares = asShares;
  }

  @Override
  public void improved(double score, double limit) {
    String unit = asShares ? " %%" : "";
    String form = "plan %.2f" + unit + ", bound %.2f" + unit + ", gap %.2f %%";
    double bound = asShares ? Math.min(1, limit) : limit;
    double gap = Math.abs(bound - score) / Math.max(Math.abs(bound), Math.abs(score));
    int factor = asShares ? 100 : 1;
    String line = Texts.format(form, factor * score, factor * bound, 100 * gap);
    if (!line.equals(last)) {
      notes.accept(line);
    }
    last = line;
  }

  @Override
  public void begins(String part) {
    notes.accept(part);
  }
}
