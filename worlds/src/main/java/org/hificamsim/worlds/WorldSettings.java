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
 * The settings that all worlds share.
 *
 * @param layouts gives the scenario of an episode by its seed; null if all episodes have {@code
 *     scenario}
 * @param reward creates the reward of each world
 * @param steps the number of steps of an episode, 1 or more
 * @param autoReset the time at which a world begins its next episode
 * @param expert creates the expert of each episode, whose advice is written; null for none
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
  /** The time of the next episode: in the call that ends one, in the next call, or on request. */
  public enum AutoReset {
    SAME_STEP,
    NEXT_STEP,
    DISABLED
  }

  /** Returns the world at the start of the episode with a seed. */
  public World world(long seed) {
    return new World(layouts == null ? scenario : layouts.apply(seed), movements, seed);
  }

  /** Checks the number of steps. */
  public WorldSettings {
    if (steps < 1) {
      throw new InputException("episodes of " + steps + " steps, expected 1 or more");
    }
  }
}
