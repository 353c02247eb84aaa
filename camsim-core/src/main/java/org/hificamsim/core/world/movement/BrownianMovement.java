package org.hificamsim.core.world.movement;

import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/** CamSim's plain random walk: each coordinate moves by a gaussian of the given mean and std. */
final class BrownianMovement implements Movement {
  private double mean;
  private double std;

  @Override
  public String name() {
    return "Brownian";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    mean = spec.mean();
    std = spec.std();
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    double dx = mean + random.move().nextGaussian() * std;
    double dy = mean + random.move().nextGaussian() * std;
    targets.advance(target, dx, dy, random.turn());
  }
}
