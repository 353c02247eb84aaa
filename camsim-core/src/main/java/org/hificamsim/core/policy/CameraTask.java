package org.hificamsim.core.policy;

/**
 * Work of a policy that is done camera by camera, see {@link NetworkView#divide}.
 *
 * @param <T> what it works on
 */
@FunctionalInterface
public interface CameraTask<T> {
  /** Does the work of the cameras from {@code from} up to, not including, {@code to}. */
  void run(NetworkView network, T work, int from, int to);
}
