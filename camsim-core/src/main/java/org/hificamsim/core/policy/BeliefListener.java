package org.hificamsim.core.policy;

/**
 * Receives a camera's belief about the positions of targets, and the messages of the step; see
 * {@link ZoomPolicy#believe}.
 */
public interface BeliefListener {
  /**
   * Called for each target that the camera follows.
   *
   * @param x the x coordinate of the expected position, in metres
   * @param y the y coordinate of the expected position, in metres
   * @param weight the probability that the target is still there, in [0, 1]
   * @param spread how far it may have strayed from the expected position since it was last seen,
   *     metres
   */
  void followed(double x, double y, double weight, double spread);

  /**
   * Called for each part of the field that no camera looks at.
   *
   * @param x the x coordinate of the centre, in metres
   * @param y the y coordinate of the centre, in metres
   * @param expected the expected number of targets there
   */
  void unseen(double x, double y, double expected);

  /** Called for each camera with the number of messages that it sent in this step. */
  default void sent(int camera, int messages) {}

  /** Called if a camera received messages from another one in this step, perhaps late ones. */
  default void received(int from, int to) {}
}
