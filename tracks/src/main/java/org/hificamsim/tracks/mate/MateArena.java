package org.hificamsim.tracks.mate;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;

/**
 * An episode of MATE's arena in this simulator, with its greedy cameras and greedy targets. The
 * layout is random. Targets carry freight between warehouses and are paid less the longer they are
 * seen; the episode ends when all freight is delivered. Whether a camera sees a target through an
 * obstacle is random for each camera and target.
 *
 * @param steps the number of steps
 * @param coverage the mean share of the targets that a camera sees
 * @param transported the pay of the targets, as a share of the greatest possible pay
 */
public record MateArena(int steps, double coverage, double transported) {
  /** The number of steps after which MATE ends an episode. */
  public static final int MAX_STEPS = 10_000;

  private static final Detection DETECTION =
      Detection.by(DetectionRule.parse("probability"), "geometric", new GeometricDetection());

  /**
   * Plays an episode.
   *
   * @param scenario MATE's field, cameras, targets and obstacles
   */
  public static MateArena play(Scenario scenario, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    ArenaLayout arena = new ArenaLayout(scenario, random.split());
    Freight freight = new Freight(arena, random.split());
    Registry<Movement> movements =
        new Registry<Movement>("movement")
            .register(
                Freight.Carrier.NAME, "with freight to warehouses", () -> freight.new Carrier());
    World world = new World(arena.scenario(), movements, seed);
    Simulation simulation = new Simulation(world, DETECTION, new GreedyCameras(), seed, List.of());
    double sum = 0;
    int steps = 0;
    for (; !freight.isDelivered() && steps < MAX_STEPS; steps++) {
      simulation.step();
      sum += simulation.coverage().score();
      freight.charge(simulation.network());
    }
    return new MateArena(steps, sum / steps, freight.payShare());
  }
}
