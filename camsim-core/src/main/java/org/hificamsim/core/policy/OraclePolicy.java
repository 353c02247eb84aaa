package org.hificamsim.core.policy;

import java.util.SplittableRandom;

/**
 * A policy that decides from what no camera knows: a bound on what is possible, which no network
 * could run. It is given the {@link OracleView}; other policies have no way to it.
 */
public interface OraclePolicy extends ZoomPolicy {
  /** Called once, before the first step. */
  default void begin(OracleView network, SplittableRandom random) {}

  /**
   * Chooses the next view of every camera; see {@link ZoomPolicy#decide}.
   *
   * @param views one entry per camera, holding the current views; the policy overwrites those of
   *     online cameras
   */
  void decide(OracleView network, int[] views);

  /** Called once per step after the observation under the views just chosen. */
  default void learn(OracleView network) {}

  @Override
  default void begin(NetworkView network, SplittableRandom random) {
    begin((OracleView) network, random);
  }

  @Override
  default void decide(NetworkView network, int[] views) {
    decide((OracleView) network, views);
  }

  @Override
  default void learn(NetworkView network) {
    learn((OracleView) network);
  }

  /**
   * Returns a policy that acts as {@code wrapper} and is given the view that the policy which it
   * wraps needs.
   *
   * @param wrapped whose methods the wrapper calls
   */
  static ZoomPolicy wrapping(ZoomPolicy wrapped, ZoomPolicy wrapper) {
    return wrapped instanceof OraclePolicy ? new OracleWrapper(wrapper) : wrapper;
  }
}
