package org.hificamsim.core.scenario;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * A camera's settings for CamSim's network of agents.
 *
 * @param algorithm auction schedule, a class name as the file gives it
 * @param comm communication policy, 0 to 4
 * @param customComm class name of a custom communication policy
 * @param limit most targets the camera may own; 0 for no limit
 * @param bandit class name of a bandit solver
 */
public record AgentSpec(
    Optional<String> algorithm,
    OptionalInt comm,
    Optional<String> customComm,
    int limit,
    Optional<String> bandit) {
  /** Nothing asked for. */
  public static final AgentSpec NONE =
      new AgentSpec(Optional.empty(), OptionalInt.empty(), Optional.empty(), 0, Optional.empty());
}
