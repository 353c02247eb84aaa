package org.hificamsim.core.engine;

/**
 * The measures of how cameras have followed targets so far; NaN if there was nothing to measure.
 *
 * @param stepsToFind the steps from the appearance of a target until a camera first covers it, mean
 *     over the appearances that were found
 * @param stepsToFindAgain the steps for which no camera covers a lost target, mean over the losses
 *     that ended
 * @param losses the number of times that no camera covered a target any more, though it was there
 * @param endedLosses the number of losses after which a camera covered the target again
 * @param unbroken the longest time for which a target was covered without a gap, as a share of the
 *     time for which it was there; mean over targets
 * @param handovers the number of times that a target passed from one camera to another without a
 *     gap
 */
public record FollowingSums(
    double stepsToFind,
    double stepsToFindAgain,
    double losses,
    double endedLosses,
    double unbroken,
    double handovers) {
  /** The sums of a run in which nothing is measured. */
  public static final FollowingSums NONE =
      new FollowingSums(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
}
