package org.hificamsim.core.world.movement;

import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * CamSim's wandering line: speed changes by a tenth of a gaussian, heading by half of one, then a
 * straight step. The speed may become negative; mean and std are not used.
 */
final class DirectedBrownianMovement implements Movement {
  @Override
  public String name() {
    return "DirectedBrownian";
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    double forSpeed = random.move().nextGaussian();
    double forHeading = random.move().nextGaussian();
    targets.accelerateTo(target, targets.speed(target) + forSpeed / 10);
    targets.turnTo(target, targets.heading(target) + forHeading / 2);
    double dx = Math.sin(targets.heading(target)) * targets.speed(target);
    double dy = Math.cos(targets.heading(target)) * targets.speed(target);
    targets.advance(target, dx, dy, random.turn());
  }
}
