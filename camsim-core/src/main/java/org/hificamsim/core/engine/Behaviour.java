package org.hificamsim.core.engine;

import org.hificamsim.core.policy.ZoomPolicy;

/**
 * How the cameras of a run act.
 *
 * @param policy chooses each camera's view
 * @param cooperation what the cameras do together
 */
public record Behaviour(ZoomPolicy policy, Cooperation cooperation) {
  /** Cameras that act by a policy alone. */
  public static Behaviour of(ZoomPolicy policy) {
    return new Behaviour(policy, Cooperation.NONE);
  }
}
