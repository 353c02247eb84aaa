package org.example.user;

import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/** Moves half a metre to the right per step. */
public final class UserMovement implements Movement {
  @Override
  public String name() {
    return "org.example.Right";
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    targets.advance(target, 0.5, 0, random.turn());
  }
}
