package org.hificamsim.network.agent;

/**
 * The parameters of the historical schedules (behaviour 8.7).
 *
 * @param preInstantiation the factor of a target's visibility before any stay in view has ended
 * @param overstay the factor for a target that has been in view longer than the average
 * @param classification whether targets are classified by their direction
 * @param categories number of directions, 1 or more
 * @param perCategory whether the average stay is kept per category; needs classification
 * @param history whether history is used at all
 */
public record HistoricalParameters(
    double preInstantiation,
    double overstay,
    boolean classification,
    int categories,
    boolean perCategory,
    boolean history) {
  /** CamSim's defaults. */
  public static final HistoricalParameters DEFAULT =
      new HistoricalParameters(20, 0, true, 4, true, true);

  /** Turns categories off if there is no classification. */
  public HistoricalParameters {
    perCategory = perCategory && classification;
  }
}
