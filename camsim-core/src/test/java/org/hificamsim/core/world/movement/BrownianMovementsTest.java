package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Compares random movements with the gaussians of a generator with the same seed. */
class BrownianMovementsTest {
  private static final long SEED = 7;

  @Test
  void brownianDrawsGaussiansByTargetWithXFirst() {
    TargetSpec first =
        TestScenario.target(1, 1, 2, 0, 99)
            .with(TargetSpec.MOVE, "epics.movement.Brownian")
            .with(TargetSpec.MEAN, 0.25)
            .with(TargetSpec.STD, 0.5);
    World world =
        new TestScenario()
            .target(first)
            .target(first.with(TargetSpec.X, -1).with(TargetSpec.Y, -2))
            .world(SEED);
    Random gaussians = new Random(SEED);
    double x0 = 1;
    double y0 = 2;
    double x1 = -1;
    double y1 = -2;
    for (int i = 0; i < 3; i++) {
      world.moveTargets();
      x0 += 0.25 + gaussians.nextGaussian() * 0.5;
      y0 += 0.25 + gaussians.nextGaussian() * 0.5;
      x1 += 0.25 + gaussians.nextGaussian() * 0.5;
      y1 += 0.25 + gaussians.nextGaussian() * 0.5;
      assertEquals(x0, world.targets().x(0));
      assertEquals(y0, world.targets().y(0));
      assertEquals(x1, world.targets().x(1));
      assertEquals(y1, world.targets().y(1));
    }
  }

  @Test
  void brownianTurnsBackAtBorderOfField() {
    TargetSpec far =
        TestScenario.target(1, 1, 2, 0, 0)
            .with(TargetSpec.MOVE, "Brownian")
            .with(TargetSpec.MEAN, 100)
            .with(TargetSpec.STD, 0);
    World world = new TestScenario().target(far).world(0);
    world.moveTargets();
    assertEquals(1, world.targets().x(0), 1e-12);
    assertEquals(2, world.targets().y(0), 1e-12);
    double u = new Random(0).nextDouble();
    assertEquals(Math.PI + ((u * 2 - 1) * Math.PI) / 6, world.targets().heading(0));
  }

  @Test
  void directedBrownianChangesSpeedThenHeading() {
    TargetSpec target =
        TestScenario.target(1, 1, 2, 30, 0.5)
            .with(TargetSpec.MOVE, "DirectedBrownian")
            .with(TargetSpec.MEAN, 77)
            .with(TargetSpec.STD, 88);
    World world = new TestScenario().target(target).world(SEED);
    Random gaussians = new Random(SEED);
    double x = 1;
    double y = 2;
    double speed = 0.5;
    double heading = Math.toRadians(30);
    for (int i = 0; i < 5; i++) {
      world.moveTargets();
      speed += gaussians.nextGaussian() / 10;
      heading += gaussians.nextGaussian() / 2;
      x += Math.sin(heading) * speed;
      y += Math.cos(heading) * speed;
      assertEquals(speed, world.targets().speed(0));
      assertEquals(heading, world.targets().heading(0));
      assertEquals(x, world.targets().x(0));
      assertEquals(y, world.targets().y(0));
    }
  }
}
