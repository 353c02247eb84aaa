package org.hificamsim.network.statistics;

/**
 * One row of CamSim's statistics (behaviour 10.1).
 *
 * @param step from 0
 * @param utility of all cameras at the end of the step
 * @param communication StartSearch messages delivered
 * @param strategyChanges cameras that changed their schedule or policy
 * @param banditUtility utility with prices of the cameras that have a bandit
 * @param attempts StartSearch messages attempted
 * @param overlap of the fields of view by CamSim's formula, square metres
 * @param confidence relative confidences, added up
 * @param proportion of the targets present that are tracked and seen
 * @param handovers StartTracking messages delivered
 * @param seeing online cameras that see anything
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
    long handovers,
    int seeing) {}
