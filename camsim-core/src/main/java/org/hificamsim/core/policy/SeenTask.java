package org.hificamsim.core.policy;

/**
 * Work of a policy that is done for each target that a camera sees, see {@link
 * NetworkView#eachSeen}.
 *
 * @param <T> what it works on
 */
@FunctionalInterface
public interface SeenTask<T> {
  /**
   * Takes note of one target.
   *
   * @param distance metres from the camera
   * @param bearing radians off the axis of the camera's view, to the right, in [-pi, pi]
   */
  void see(T work, int target, double distance, double bearing);
}
