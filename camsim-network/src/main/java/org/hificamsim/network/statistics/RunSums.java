package org.hificamsim.network.statistics;

import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The sums of a run's figures, one row of CamSim's summary file (behaviour 10.5). */
public final class RunSums {
  /** The columns. Those without CUMULATIVE in front are of a step that never began, hence 0. */
  public static final String HEADER =
      "SEED,TIME,GLOBAL_UTILITY,CUMULATIVE_UTILITY,COMMUNICATION,CUMULATIVE_COMM,HANDOVER,"
          + "CUMULATIVE_HANDOVER,CUMULATIVE_COMM_OH,VISIBLE,OVERLAP,CONFIDENCE,PROPORTION";

  private long steps;
  private double utility;
  private long communication;
  private long handovers;
  private long attempts;
  private double overlap;
  private double confidence;
  private double proportion;

  /** Adds a step. */
  public void add(StepFigures figures) {
    steps++;
    utility += figures.utility();
    communication += figures.communication();
    handovers += figures.handovers();
    attempts += figures.attempts();
    overlap += figures.overlap();
    confidence += figures.confidence();
    proportion += figures.proportion();
  }

  /** The StartSearch messages delivered. */
  public long communication() {
    return communication;
  }

  /** The StartTracking messages delivered. */
  public long handovers() {
    return handovers;
  }

  /** The utility of all steps together. */
  public double utility() {
    return utility;
  }

  /** The mean over the steps of the proportion tracked; 0 without steps. */
  public double meanProportion() {
    return steps == 0 ? 0 : proportion / steps;
  }

  /** The row of the summary. */
  public String row(long seed) {
    return Stream.of(
            seed,
            steps,
            0.0,
            utility,
            0.0,
            (double) communication,
            0.0,
            (double) handovers,
            (double) attempts,
            0,
            overlap,
            confidence,
            proportion)
        .map(String::valueOf)
        .collect(Collectors.joining(","));
  }
}
