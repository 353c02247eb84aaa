package org.hificamsim.presentation.report;

import org.hificamsim.core.metrics.Objective;

/**
 * What a page calls its score.
 *
 * @param text the objective as an option
 * @param title what the score of a step is
 * @param share whether it is shown in percent
 * @param kMin whether it is k_min, which pages have anyway
 */
public record ObjectiveWords(String text, String title, boolean share, boolean kMin) {
  public static ObjectiveWords of(Objective objective) {
    return new ObjectiveWords(
        objective.text(), objective.words(), objective.isShare(), !objective.hasOwnFigure());
  }
}
