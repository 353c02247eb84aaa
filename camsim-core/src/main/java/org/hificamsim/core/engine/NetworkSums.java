package org.hificamsim.core.engine;

/**
 * The sums of the joint actions of a network's cameras over all steps so far.
 *
 * @param utility the visibility of the targets that cameras own, weighted by their range
 * @param messages the delivered messages that the network counts
 * @param bits the bits of all messages
 * @param invitations the attempted messages that the network counts
 * @param handovers the number of times that a target passed from one camera to another
 * @param overlap the overlap of fields of view, in square metres, by the network's own formula
 * @param confidence the sum of the relative confidences of cameras
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
  /** The sums of cameras without a network, which are unknown. */
  public static final NetworkSums NONE =
      new NetworkSums(Double.NaN, 0, 0, 0, 0, Double.NaN, Double.NaN, Double.NaN);

  /** A count as a metric; NaN without a network. */
  public double counted(long count) {
    return Double.isNaN(utility) ? Double.NaN : count;
  }
}
