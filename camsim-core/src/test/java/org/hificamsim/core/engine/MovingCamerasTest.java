package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests moves of a camera with two levels at -40, 0 and 40 degrees that turns by 20 degrees per
 * step.
 */
class MovingCamerasTest {
  private static final int AHEAD = 3;
  private static final int RIGHT = 5;
  private static final int RIGHT_NARROW = 4;

  /** Looks to the right. */
  private record ToTheRight(boolean jumps) implements ZoomPolicy {
    @Override
    public String name() {
      return "to the right";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      views[0] = RIGHT;
    }
  }

  /** Looks to the right at a given pan angle. */
  private record Aiming(double pan) implements AimingZoomPolicy {
    @Override
    public String name() {
      return "aiming";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      views[0] = RIGHT;
    }

    @Override
    public double pan(int camera) {
      return pan;
    }
  }

  @Test
  void cameraMovesForSeveralStepsBeforeItSees() {
    Simulation simulation = simulation(new ToTheRight(false));
    NetworkView network = simulation.network();
    assertEquals(2, network.zooms(0));
    assertFalse(network.moving(0));
    assertTrue(network.reaches(0, AHEAD - 1));
    assertFalse(network.reaches(0, RIGHT));
    simulation.run(1);
    assertTrue(network.moving(0));
    assertEquals(Cameras.NO_VIEW, network.seeing(0));
    assertTrue(network.reaches(0, RIGHT));
    assertTrue(network.reaches(0, RIGHT_NARROW));
    simulation.run(1);
    assertFalse(network.moving(0));
    assertEquals(RIGHT, network.seeing(0));
  }

  @Test
  void boundArrivesAtOnce() {
    Simulation simulation = simulation(new ToTheRight(true));
    simulation.run(1);
    assertEquals(RIGHT, simulation.network().seeing(0));
    assertFalse(simulation.network().moving(0));
  }

  @ParameterizedTest
  @CsvSource({"0.3, 0.3", "NaN, 0.6981317007977318"})
  void aimingPolicyTurnsToItsPanAngle(double aimed, double pan) {
    Simulation simulation = simulation(new Aiming(aimed));
    simulation.run(1);
    assertEquals(RIGHT, simulation.network().seeing(0));
    assertEquals(pan, simulation.network().pan(0, RIGHT), 1e-15);
  }

  private static Simulation simulation(ZoomPolicy policy) {
    OpticsSpec optics =
        new OpticsSpec("turning")
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(30.0, 60.0))
            .with(OpticsSpec.PANS, List.of(-40.0, 0.0, 40.0))
            .with(OpticsSpec.PAN_SPEED, 20);
    World world =
        new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, optics)).target(0, 3).world();
    return new Simulation(world, Detection.of(new GeometricDetection()), policy, 0, List.of());
  }
}
