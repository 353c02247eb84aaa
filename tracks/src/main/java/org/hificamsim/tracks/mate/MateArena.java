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
 * An episode of MATE's arena: its greedy cameras against its greedy targets, in this simulator. The
 * layout is drawn anew; targets carry freight between warehouses, and are paid the less the longer
 * they are seen; the episode ends when all is delivered. A look through an obstacle succeeds by a
 * draw for each camera and target.
 *
 * @param steps how many it took
 * @param coverage mean share of the targets that a camera sees
 * @param transported what the targets were paid, as a part of what they could be
 */
public record MateArena(int steps, double coverage, double transported) {
  /** After which MATE ends an episode. */
  public static final int MOST_STEPS = 10_000;

  private static final Detection DETECTION =
      Detection.by(DetectionRule.parse("probability"), "geometric", new GeometricDetection());

  /**
   * Plays an episode.
   *
   * @param site MATE's field, cameras, targets and obstacles, wherever they stand
   */
  public static MateArena play(Scenario site, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    ArenaLayout arena = new ArenaLayout(site, random.split());
    Freight freight = new Freight(arena, random.split());
    Registry<Movement> movements =
        new Registry<Movement>("movement")
            .register(
                Freight.Carrier.NAME, "with freight to warehouses", () -> freight.new Carrier());
    World world = new World(arena.drawn(), movements, seed);
    Simulation simulation = new Simulation(world, DETECTION, new GreedyCameras(), seed, List.of());
    double covered = 0;
    int steps = 0;
    for (; !freight.delivered() && steps < MOST_STEPS; steps++) {
      simulation.step();
      covered += simulation.coverage().score();
      freight.charge(simulation.network());
    }
    return new MateArena(steps, covered / steps, freight.paid());
  }
}
