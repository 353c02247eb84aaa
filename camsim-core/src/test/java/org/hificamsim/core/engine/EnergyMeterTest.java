package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.energy.EnergyFigure;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DutyCycle;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.WorldObserver;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnergyMeterTest {
  private static final class Levels implements ZoomPolicy {
    @Override
    public String name() {
      return "levels";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      views[0] = (int) (network.step() % 3);
    }
  }

  private static CameraSpec camera(String name, String duty) {
    CameraSpec camera = new CameraSpec(name, 0, 0, 5);
    return duty == null ? camera : camera.with(CameraSpec.DUTY, DutyCycle.parse(duty));
  }

  private static TestScenario scenario(String energy) {
    return new TestScenario()
        .with(Scenario.ENERGY, EnergyModel.parse(energy))
        .target(1, 0, 0, 0)
        .target(0, 2, 0, 0);
  }

  private static Simulation simulation(World world, ZoomPolicy policy) {
    Detection detection = Detection.of(new GeometricDetection());
    return new Simulation(world, detection, policy, 0, List.of());
  }

  @Test
  void batteryLastsComputedNumberOfSteps() {
    // A step takes 1 W x 1 s + 0.5 J + 2 x 0.25 J = 2 J, so that 19 J last 10 steps.
    World world = scenario("idle=1W,sense=500mJ,detection=250mJ,battery=19J").camera(0, 0).world();
    int[] failed = {0};
    world.observe(
        new WorldObserver() {
          @Override
          public void cameraFailed(int camera, int duration) {
            failed[0]++;
          }
        });
    Simulation simulation = simulation(world, new WidestPolicy());
    simulation.run(9);
    assertTrue(world.cameras().online(0));
    simulation.run(1);
    assertFalse(world.cameras().online(0));
    simulation.run(10);
    assertEquals(new EnergySums(20, 10, 10, 1, 1), simulation.energy());
    assertEquals(1, failed[0]);
  }

  @Test
  void halfOfTheBatteriesAreEmptyAfterTheFirst() {
    World world =
        scenario("idle=1W,sleep=0.25W,battery=8J")
            .camera(camera("always", null))
            .camera(camera("third", "1/3"))
            .camera(camera("half", "1/2"))
            .camera(camera("fifth", "1/5@4"))
            .world();
    Simulation simulation = simulation(world, new WidestPolicy());
    simulation.run(200);
    // 8 steps; and 1 + .25 J in two steps, so that 12 steps take 7.5 J of the 8 J, and 13 take 8.5.
    assertEquals(8, simulation.energy().firstEmpty());
    assertEquals(13, simulation.energy().halfEmpty());
  }

  @Test
  void zoomingTakesEnergyForEachLevel() {
    World world = scenario("zoom=2J").camera(0, 0).zooms(1, 2, 3).world();
    Simulation simulation = simulation(world, new Levels());
    simulation.run(7); // levels 0 1 2 0 1 2 0
    assertEquals(2.0 * (1 + 1 + 2 + 1 + 1 + 2), simulation.energy().joules());
  }

  @Test
  void joulesAreTheSumOfTheirParts() {
    World world =
        scenario("idle=0.3W,sleep=0.1W,sense=0.7J,detection=0.9J,zoom=0.11J")
            .camera(camera("a", null))
            .camera(camera("b", "2/3@1"))
            .zooms(1, 2, 3)
            .world();
    Simulation simulation = simulation(world, new Levels());
    simulation.run(100);
    EnergyMeter meter = simulation.energyMeter().orElseThrow();
    double sum = 0;
    for (EnergyFigure figure : EnergyFigure.values()) {
      sum += meter.joules(0, figure) + meter.joules(1, figure);
    }
    assertEquals(simulation.energy().joules(), sum, 1e-9);
    assertEquals(33 * 0.1, meter.joules(1, EnergyFigure.SLEEP), 0.11);
  }

  /** Adds up the parts of each camera after every step. */
  @Test
  void batteryChargeFallsByTheEnergyTaken() {
    World world =
        scenario("idle=0.3W,sleep=0.1W,sense=0.7J,detection=0.9J,zoom=0.11J,battery=1kJ")
            .with(Scenario.PROCESSING, new ProcessingBudget(1))
            .camera(camera("a", null))
            .camera(camera("b", "2/3@1"))
            .zooms(1, 2, 3)
            .world();
    Simulation simulation = simulation(world, new Levels());
    EnergyMeter meter = simulation.energyMeter().orElseThrow();
    double before = 0;
    for (int step = 0; step < 60; step++) {
      simulation.step();
      double taken = 0;
      for (int camera = 0; camera < 2; camera++) {
        double parts = 0;
        for (EnergyFigure figure : EnergyFigure.values()) {
          parts += meter.joules(camera, figure);
        }
        assertEquals(1000 - meter.left(camera), parts, 1e-9, "camera " + camera);
        taken += parts;
      }
      assertEquals(simulation.energy().joules(), taken, 1e-9, "step " + step);
      assertTrue(taken > before, "step " + step);
      before = taken;
    }
  }

  @Test
  void sleepingCameraSeesNothing() {
    World world = scenario("none").camera(camera("a", "2/5@1")).world();
    Simulation simulation = simulation(world, new WidestPolicy());
    StringBuilder seen = new StringBuilder();
    for (int step = 0; step < 10; step++) {
      simulation.step();
      seen.append(simulation.network().detected(0));
    }
    assertEquals("0220002200", seen.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"0/5", "6/5", "1/0", "-1/5", "1/5@5", "1/5@-1", "1", "", "x/5", "1.5/5"})
  void rejectsInvalidDutyCycles(String text) {
    assertThrows(IllegalArgumentException.class, () -> DutyCycle.parse(text));
  }
}
