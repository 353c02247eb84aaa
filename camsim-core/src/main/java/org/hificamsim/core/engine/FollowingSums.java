package org.hificamsim.core.engine;

/**
 * How the cameras of a run followed targets so far; NaN where there was nothing to measure.
 *
 * @param stepsToFind from the appearance of a target until a camera first covers it, mean over the
 *     appearances that were found
 * @param stepsToFindAgain for which a lost target is covered by no camera, mean over the losses
 *     that ended
 * @param losses the number of times that no camera covered a target any more, though it was there
 * @param endedLosses those of them after which a camera covered the target again
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
