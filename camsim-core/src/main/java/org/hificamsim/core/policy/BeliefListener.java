package org.hificamsim.core.policy;

/**
 * Is told what a camera believes of where targets are, and who told whom; see {@link
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

  /** A camera, any one, has sent so many messages in this step. */
  default void told(int camera, int messages) {}

  /** Of a camera's messages, of this step or late ones, some have arrived at another one now. */
  default void heard(int from, int to) {}
}
