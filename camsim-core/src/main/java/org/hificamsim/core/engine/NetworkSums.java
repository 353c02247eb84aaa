package org.hificamsim.core.engine;

/**
 * What the cameras of a network did together, summed over the steps so far.
 *
 * @param utility the visibility of the targets that cameras own, weighed by their range
 * @param messages that count, delivered
 * @param bits of all messages
 * @param invitations messages that count, sent or tried
 * @param handovers targets that went from one camera to another
 * @param overlap of fields of view, square metres, by the network's own formula
 * @param confidence relative confidences of cameras
 * @param tracked the share of targets that an owner sees
 */
public record NetworkSums(
    double utility,
    long messages,
    long bits,
    long invitations,
    long handovers,
    double overlap,
    double confidence,
    double tracked) {
  /** Of cameras that are no network: nothing is known. */
  public static final NetworkSums NONE =
      new NetworkSums(Double.NaN, 0, 0, 0, 0, Double.NaN, Double.NaN, Double.NaN);

  /** A count as a metric; NaN where there is no network. */
  public double counted(long count) {
    return Double.isNaN(utility) ? Double.NaN : count;
  }
}
