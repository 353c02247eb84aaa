package org.hificamsim.network.statistics;

/**
 * One row of CamSim's statistics (behaviour 10.1), or the sums of several.
 *
 * @param step the step, from 0; in sums the number of steps
 * @param utility the utility of all cameras at the end of the step
 * @param communication the number of StartSearch messages delivered
 * @param strategyChanges the number of cameras that changed their schedule or policy
 * @param banditUtility the utility and prices of the cameras with a bandit
 * @param attempts the number of StartSearch messages attempted
 * @param overlap the overlap of the fields of view by CamSim's formula, in square metres
 * @param confidence the sum of the relative confidences
 * @param proportion the share of the present targets that are tracked and seen
 * @param handovers the number of StartTracking messages delivered
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
  /** The sums over no steps. */
  public static final StepFigures NONE = new StepFigures(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

  /** Returns these sums plus one further step. */
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

  /** The mean proportion over the steps; 0 without steps. */
  public double meanProportion() {
    return step == 0 ? 0 : proportion / step;
  }
}
