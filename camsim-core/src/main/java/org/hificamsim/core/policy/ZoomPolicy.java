package org.hificamsim.core.policy;

import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.registry.Options;

/**
 * Chooses each camera's view, step by step: an extension point, found by {@link #name}.
 *
 * <p>An implementer writes {@link #name} and {@link #decide}; a learning policy also {@link #begin}
 * (to size its tables) and {@link #learn}. Given a public constructor without arguments and a
 * service declaration, a user's own policy runs from the command line. An instance serves one run;
 * all its randomness comes from the generator handed to {@link #begin}.
 */
public interface ZoomPolicy {
  /** The name on the command line and in result files. */
  String name();

  /**
   * Reads the options that follow the name, each by a getter of {@code options}; options that are
   * not read are refused afterwards.
   *
   * @throws org.hificamsim.core.InputException if a value is malformed or out of range
   */
  default void configure(Options options) {}

  /**
   * The files by which the policy decides, such as a trained network, known after {@link
   * #configure}. Run keys depend on their content, and results have a copy.
   */
  default List<Path> files() {
    return List.of();
  }

  /**
   * Called once, before the first step.
   *
   * @param network the network, the same object at every call of the run; its answers change with
   *     each step
   */
  default void begin(NetworkView network, SplittableRandom random) {}

  /**
   * Chooses the next view of every camera.
   *
   * @param network the network as it is known before the step's observation
   * @param views one entry per camera, holding the current views; the policy overwrites those of
   *     online cameras with values in [0, views(camera)); entries of offline cameras are ignored
   */
  void decide(NetworkView network, int[] views);

  /**
   * Whether the policy's cameras move in no time: such a policy is a bound on what is possible,
   * which no network could run.
   */
  default boolean jumps() {
    return false;
  }

  /** Called once per step after the observation under the views just chosen. */
  default void learn(NetworkView network) {}

  /**
   * Reports what a camera has learned about its views, for listeners; called at the end of a step.
   *
   * @param estimates receives one entry for each view; NaN for none
   * @param counts receives the number of observations behind each estimate; NaN if not counted
   * @return what is estimated, such as "mean reward" or "Q", the same at every call; empty if the
   *     policy estimates nothing, which leaves the arrays unchanged
   */
  default String estimates(int camera, double[] estimates, double[] counts) {
    return "";
  }

  /**
   * Reports a camera's belief about the positions of targets, and the messages of all cameras, for
   * listeners; called at the end of a step.
   *
   * @return whether the policy has beliefs, the same at every call
   */
  default boolean believe(int camera, BeliefListener listener) {
    return false;
  }

  /**
   * The number of messages that the cameras have sent so far; a message to all others counts once.
   */
  default long messages() {
    return 0;
  }

  /** The bits of these messages; see {@link org.hificamsim.core.channel.MessageBits}. */
  default long bits() {
    return 0;
  }
}
