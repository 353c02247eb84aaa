package org.hificamsim.worlds;

import java.util.function.Supplier;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;

/**
 * What all worlds have in common.
 *
 * @param reward makes one for each world
 * @param steps of an episode, 1 or more
 * @param autoReset whether a world whose episode ends begins the next one within the same call
 * @param expert makes one for each episode, whose advice is written; null for none
 */
public record WorldSettings(
    Scenario scenario,
    Registry<Movement> movements,
    Detection detection,
    ObservationLayout layout,
    ActionKind actions,
    Supplier<Reward> reward,
    int steps,
    boolean autoReset,
    Supplier<ZoomPolicy> expert) {
  /** Checks the length of an episode. */
  public WorldSettings {
    if (steps < 1) {
      throw new InputException("episodes of " + steps + " steps, expected 1 or more");
    }
  }
}
