package org.example;

import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/** A movement of one's own: a circle to the right of the start, at the target's speed. */
public final class CirclingMovement implements Movement {
  private static final double RADIUS = 2; // metres

  private double turn;

  @Override
  public String name() {
    return "Circling";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    turn = 2 * Math.asin(targets.speed(target) / (2 * RADIUS));
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    double along = targets.heading(target) + turn / 2;
    double dx = targets.speed(target) * Math.sin(along);
    double dy = targets.speed(target) * Math.cos(along);
    if (targets.advance(target, dx, dy, random.turn())) {
      targets.turnTo(target, targets.heading(target) + turn);
    }
  }
}
