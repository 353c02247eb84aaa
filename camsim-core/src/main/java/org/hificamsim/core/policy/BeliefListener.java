package org.hificamsim.core.policy;

/**
 * Receives what a camera believes of where targets are, and who sent messages to whom; see {@link
 * ZoomPolicy#believe}.
 */
public interface BeliefListener {
  /**
   * A target that is followed.
   *
   * @param x metres, where it should be now
   * @param y metres
   * @param weight how likely it is there, [0, 1]
   * @param spread how far it may have gone elsewhere since it was last seen, metres
   */
  void followed(double x, double y, double weight, double spread);

  /**
   * A part of the field that nobody looks at.
   *
   * @param x of its centre, metres
   * @param y metres
   * @param expected number of targets in it
   */
  void unseen(double x, double y, double expected);

  /** A camera has sent this many messages in this step; called for all cameras. */
  default void told(int camera, int messages) {}

  /** Another camera has received some of a camera's messages in this step, perhaps late ones. */
  default void heard(int from, int to) {}
}
