package org.hificamsim.core.engine;

import org.hificamsim.core.policy.ZoomPolicy;

/**
 * The behaviour of the cameras of a run.
 *
 * @param policy the policy that chooses each camera's view
 * @param cooperation the joint actions of the cameras
 */
public record Behaviour(ZoomPolicy policy, Cooperation cooperation) {
  /** Returns the behaviour of cameras that only follow a policy. */
  public static Behaviour of(ZoomPolicy policy) {
    return new Behaviour(policy, Cooperation.NONE);
  }
}
