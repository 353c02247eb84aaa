package org.hificamsim.core.world.movement;

import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/** A straight line at constant speed, turning at the border (Eq 3.3). */
final class StraightMovement implements Movement {
  private double dx;
  private double dy;

  @Override
  public String name() {
    return "Straight";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    face(target, targets);
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    if (!targets.advance(target, dx, dy, random.turn())) {
      face(target, targets);
    }
  }

  private void face(int target, Targets targets) {
    dx = Math.sin(targets.heading(target)) * targets.speed(target);
    dy = Math.cos(targets.heading(target)) * targets.speed(target);
  }
}
