package org.hificamsim.network.statistics;

/**
 * One row of CamSim's statistics (behaviour 10.1), or the sums of several.
 *
 * @param step from 0; of sums the number of steps
 * @param utility of all cameras at the end of the step
 * @param communication StartSearch messages delivered
 * @param strategyChanges cameras that changed their schedule or policy
 * @param banditUtility utility with prices of the cameras that have a bandit
 * @param attempts StartSearch messages attempted
 * @param overlap of the fields of view by CamSim's formula, square metres
 * @param confidence relative confidences, added up
 * @param proportion of the targets present that are tracked and seen
 * @param handovers StartTracking messages delivered
 */
public record StepFigures(
    long step,
    double utility,
    long communication,
    int strategyChanges,
    double banditUtility,
    long attempts,
    double overlap,
    double confidence,
    double proportion,
    long handovers) {
  /** The sums of no step. */
  public static final StepFigures NONE = new StepFigures(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /** These sums and one step more. */
  public StepFigures plus(StepFigures next) {
    return new StepFigures(
        step + 1,
        utility + next.utility,
        communication + next.communication,
        strategyChanges + next.strategyChanges,
        banditUtility + next.banditUtility,
        attempts + next.attempts,
        overlap + next.overlap,
        confidence + next.confidence,
        proportion + next.proportion,
        handovers + next.handovers);
  }

  /** The mean over the steps of the proportion tracked; 0 without steps. */
  public double meanProportion() {
    return step == 0 ? 0 : proportion / step;
  }
}
