package org.hificamsim.presentation.report;

import org.hificamsim.core.metrics.Objective;

/**
 * The words by which pages name the score.
 *
 * @param text the objective as an option
 * @param title the title of the score of a step
 * @param share whether the score is shown in percent
 * @param kMin whether the score is k_min, which pages always show
 */
public record ObjectiveWords(String text, String title, boolean share, boolean kMin) {
  public static ObjectiveWords of(Objective objective) {
    return new ObjectiveWords(
        objective.text(), objective.words(), objective.isShare(), !objective.hasOwnFigure());
  }
}
