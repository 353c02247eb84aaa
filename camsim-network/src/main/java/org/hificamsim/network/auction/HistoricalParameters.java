package org.hificamsim.network.auction;

/**
 * The parameters of the historical schedules (behaviour 8.7).
 *
 * @param preInstantiation what a target's visibility is multiplied by while nothing is known of how
 *     long such targets stay in view
 * @param overstay the same for a target that has been in view longer than the average
 * @param classification whether targets are told apart by their direction
 * @param categories how many directions are told apart, 1 or more
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

  public HistoricalParameters {
    perCategory = perCategory && classification;
  }
}
