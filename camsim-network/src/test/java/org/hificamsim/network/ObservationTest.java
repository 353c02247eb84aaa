package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.WidestPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests that cameras of a network look once per step, and that coverage counts only what they saw.
 */
class ObservationTest {
  private static final int STEPS = 20;

  /** A model with confidence 1 that counts its calls. */
  private record Counting(AtomicInteger calls) implements DetectionModel {
    @Override
    public String name() {
      return "counting";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      calls.incrementAndGet();
      return 1;
    }

    @Override
    public boolean dependsOnBearing() {
      return true;
    }
  }

  @Test
  void asksModelOncePerPairWithinReach() {
    Counting model = new Counting(new AtomicInteger());
    Simulation simulation = simulation(world(), model);
    long pairs = 0;
    for (int step = 0; step < STEPS; step++) {
      simulation.step();
      pairs += simulation.coverage().detections();
      assertEquals(pairs, model.calls().get());
    }
    assertTrue(pairs > STEPS);
  }

  @Test
  void coverageCountsSeenTargets() {
    World world = world();
    Network network =
        new Network(
            world, Detection.of(new Counting(new AtomicInteger())), NetworkSettings.CAMSIM, 0);
    Simulation simulation = simulation(world, new Counting(new AtomicInteger()), network);
    for (int step = 0; step < STEPS; step++) {
      simulation.step();
      OracleView view = simulation.network();
      for (int target = 0; target < view.targets(); target++) {
        int seen = 0;
        for (int camera = 0; camera < view.cameras(); camera++) {
          boolean sees = view.online(camera) && network.sightings().sees(camera, target);
          seen += sees ? 1 : 0;
          assertEquals(sees, view.online(camera) && view.detects(camera, 0, target));
        }
        assertEquals(seen, view.coverage(target), "step " + step + " target " + target);
      }
    }
    assertEquals(0, simulation.network().detected(2));
  }

  @Test
  void targetAtSectorCameraIsNeitherSeenNorCounted() {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 1, 1, 0, 90, 5))
            .camera(TestScenario.camera("b", 1, 0, 0, 90, 5))
            .target(1, 1)
            .world();
    Simulation simulation = simulation(world, new Counting(new AtomicInteger()));
    simulation.step();
    assertFalse(simulation.network().detects(0, 0, 0));
    assertEquals(0, simulation.network().detected(0));
    assertEquals(1, simulation.network().coverage(0));
  }

  private static World world() {
    TestScenario scenario =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 6))
            .camera(TestScenario.camera("b", 3, 0, 200, 200, 4))
            .camera(TestScenario.camera("c", -3, 3, 0, 360, 5))
            .events(new FailCamera(9, "c", -1));
    for (int target = 0; target < 12; target++) {
      scenario.target(target % 4 - 2, Math.floorDiv(target, 4), 33 * target, 0.5);
    }
    return scenario.world();
  }

  private static Simulation simulation(World world, DetectionModel model) {
    Detection detection = Detection.of(model);
    return simulation(world, model, new Network(world, detection, NetworkSettings.CAMSIM, 0));
  }

  private static Simulation simulation(World world, DetectionModel model, Network network) {
    return new Simulation(
        world, Detection.of(model), new Behaviour(new WidestPolicy(), network), 0, List.of());
  }
}
