package org.hificamsim.core.world;

import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * Moves one target, step by step: an extension point, found by {@link #name} through a scenario's
 * {@code move} or {@code fqName} attribute.
 *
 * <p>An implementer writes {@link #move}, {@link #name} if it is not the class's, and {@link
 * #start} if it needs parameters. Each target has an instance of its own, so fields may hold state.
 * {@link Targets#advance} handles the border of the field.
 */
public interface Movement {
  /** The name in scenario files. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** Called once, when the target appears with its start position, heading and speed set. */
  default void start(int target, Targets targets, TargetSpec spec) {}

  /** Moves the target by one step. */
  void move(int target, Targets targets, RandomStreams random);
}
