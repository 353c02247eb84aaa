package org.hificamsim.tracks.mate;

import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * A greedy target of MATE's arena: straight to the warehouse that its freight is for, with a swerve
 * of up to half its speed in x and in y, another one every ten steps or so.
 */
final class Carrier implements Movement {
  static final String NAME = "Carrier";

  private static final double WAREHOUSE = 925;
  private static final double HALF_WIDTH = 75;
  private static final double CHANGE = 0.1;

  private final Freight freight;
  private final Walls walls;
  private double swerveX;
  private double swerveY;
  private boolean swerves;

  Carrier(Freight freight, Walls walls) {
    this.freight = freight;
    this.walls = walls;
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    if (distance(target, targets) <= HALF_WIDTH) {
      freight.arrive(target);
    }
    if (!swerves || random.move().nextDouble() < CHANGE) {
      swerves = true;
      swerveX = random.move().nextDouble() - 0.5;
      swerveY = random.move().nextDouble() - 0.5;
    }
    double dx = toX(target) - targets.x(target);
    double dy = toY(target) - targets.y(target);
    double way = Math.hypot(dx, dy);
    double x = dx / way + swerveX;
    double y = dy / way + swerveY;
    double speed = targets.speed(target) / Math.max(1, Math.hypot(x, y));
    walls.step(target, targets, speed * x, speed * y);
  }

  /** From the middle of the warehouse, the greater of x and y. */
  private double distance(int target, Targets targets) {
    return Math.max(
        Math.abs(targets.x(target) - toX(target)), Math.abs(targets.y(target) - toY(target)));
  }

  private double toX(int target) {
    return freight.goal(target) % 2 == 0 ? -WAREHOUSE : WAREHOUSE;
  }

  private double toY(int target) {
    return freight.goal(target) < 2 ? -WAREHOUSE : WAREHOUSE;
  }
}
