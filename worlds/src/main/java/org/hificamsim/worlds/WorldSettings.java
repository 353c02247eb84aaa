package org.hificamsim.worlds;

import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;

/**
 * What all worlds have in common.
 *
 * @param layouts the scenario of an episode, by its seed; null where all episodes have the same
 * @param reward makes one for each world
 * @param steps of an episode, 1 or more
 * @param autoReset when a world whose episode has ended begins the next one
 * @param expert makes one for each episode, whose advice is written; null for none
 */
public record WorldSettings(
    Scenario scenario,
    LongFunction<Scenario> layouts,
    Registry<Movement> movements,
    Detection detection,
    ObservationLayout layout,
    ActionKind actions,
    Supplier<Reward> reward,
    int steps,
    AutoReset autoReset,
    Supplier<ZoomPolicy> expert) {
  /** When the next episode begins: within the call that ends one, in the next one, or if asked. */
  public enum AutoReset {
    SAME_STEP,
    NEXT_STEP,
    DISABLED
  }

  /** The world of an episode at its start, by the episode's seed. */
  public World world(long seed) {
    return new World(layouts == null ? scenario : layouts.apply(seed), movements, seed);
  }

  /** Checks the length of an episode. */
  public WorldSettings {
    if (steps < 1) {
      throw new InputException("episodes of " + steps + " steps, expected 1 or more");
    }
  }
}
