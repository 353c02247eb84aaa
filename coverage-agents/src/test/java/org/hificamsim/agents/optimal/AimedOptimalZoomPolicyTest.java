package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.OpticsLaw;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Cameras that turn to any angle, against lists of angles. */
class AimedOptimalZoomPolicyTest {
  private static final int STEPS = 25;

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=2"})
  void anyAngleIsAsGoodAsAFineListAndBetterThanACoarseOne(String objective) {
    int above = 0;
    double fine = 0;
    double any = 0;
    for (int seed = 0; seed < 6; seed++) {
      double[] ofCoarse = scores(scenario(seed, 30, objective), "optimal", seed);
      double[] ofFine = scores(scenario(seed, 0.5, objective), "optimal", seed);
      double[] ofAny = scores(scenario(seed, 30, objective), "optimal:pan=continuous", seed);
      for (int step = 0; step < STEPS; step++) {
        assertTrue(ofAny[step] >= ofFine[step], "step " + step + " of seed " + seed);
        assertTrue(ofAny[step] >= ofCoarse[step]);
        above += ofAny[step] > ofCoarse[step] ? 1 : 0;
      }
      fine += DoubleStream.of(ofFine).sum();
      any += DoubleStream.of(ofAny).sum();
    }
    assertTrue(above > 2, "above the coarse list in " + above + " steps");
    assertEquals(1, any / fine, 0.05, "a list every half degree comes near");
  }

  private static double[] scores(Scenario scenario, String policy, long seed) {
    Registry<ZoomPolicy> policies = CoveragePolicies.register(new Registry<>("policy"));
    ZoomPolicy made = policies.create(policy);
    World world = new World(scenario, Movements.registry(), seed);
    Simulation simulation =
        new Simulation(world, Detection.of(new GeometricDetection()), made, seed, List.of());
    double[] scores = new double[STEPS];
    for (int step = 0; step < STEPS; step++) {
      simulation.step();
      scores[step] = simulation.coverage().score();
    }
    assertEquals(0, ((ProvingZoomPolicy) made).unprovenSteps());
    return scores;
  }

  private static Scenario scenario(long seed, double panStep, String objective) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Double> pans = new ArrayList<>();
    for (double pan = -60; pan <= 60; pan += panStep) {
      pans.add(pan);
    }
    OpticsSpec optics =
        new OpticsSpec("ptz")
            .with(OpticsSpec.LAW, OpticsLaw.CONSTANT_AREA)
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(10.0, 25.0, 50.0))
            .with(OpticsSpec.REACH, 18)
            .with(OpticsSpec.PANS, pans)
            .with(OpticsSpec.PAN_SPEED, 1) // too slow for any policy that does not jump
            .with(OpticsSpec.ZOOM_TIME, 5);
    TestScenario scenario = new TestScenario();
    for (int camera = 0; camera < 5; camera++) {
      scenario.camera(
          TestScenario.camera(
              "c" + camera,
              random.nextDouble(-9, 9),
              random.nextDouble(-9, 9),
              random.nextDouble(360),
              optics));
    }
    for (int target = 0; target < 6; target++) {
      scenario.target(
          TestScenario.target(target, random.nextDouble(-9, 9), random.nextDouble(-9, 9), 0, 0.5)
              .withMovement("RandomWaypoint"));
    }
    List<Obstacle> walls =
        List.of(new Obstacle.Wall(-3, 1.5, 4, 1.25, 0), new Obstacle.Pillar(5, -5, 0.75, 0));
    return scenario
        .with(Scenario.OBSTACLES, walls)
        .scenario()
        .with(Scenario.OBJECTIVE, Objective.parse(objective));
  }
}
