package org.hificamsim.core.world.movement;

import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * The random waypoint model: the target walks straight to a position drawn uniformly from the
 * field, and then to another one. A position behind a solid obstacle is drawn again, up to {@value
 * #DRAWS} times; if all are, the target stands still for the step.
 */
final class RandomWaypointMovement implements Movement {
  private static final int DRAWS = 100;

  private boolean walking;
  private double toX;
  private double toY;

  @Override
  public String name() {
    return "RandomWaypoint";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    walking = false;
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    if (walking || draw(target, targets, random)) {
      walk(target, targets);
    }
  }

  private boolean draw(int target, Targets targets, RandomStreams random) {
    Field field = targets.field();
    for (int i = 0; i < DRAWS && !walking; i++) {
      toX = field.minX() + random.move().nextDouble() * field.width();
      toY = field.minY() + random.move().nextDouble() * field.height();
      walking = targets.canWalk(target, toX, toY);
    }
    return walking;
  }

  private void walk(int target, Targets targets) {
    double dx = toX - targets.x(target);
    double dy = toY - targets.y(target);
    double distance = Math.sqrt(dx * dx + dy * dy);
    double speed = Math.abs(targets.speed(target));
    walking = distance > speed;
    double part = walking ? speed / distance : 1;
    targets.turnTo(target, Math.atan2(dx, dy));
    targets.put(target, targets.x(target) + part * dx, targets.y(target) + part * dy);
  }
}
