package org.hificamsim.core.world.movement;

import java.util.List;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Waypoint;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * The coverage study's waypoints: the target starts on the first one and walks towards the next;
 * when that is within one step it lands on it exactly and turns to the one after, cyclically. Of a
 * speed below 0, with which it would never arrive, the size counts.
 */
final class ScriptedMovement implements Movement {
  private List<Waypoint> path;
  private int next = 1;

  @Override
  public String name() {
    return "Scripted";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    path = spec.waypoints();
    targets.put(target, path.get(0).x(), path.get(0).y());
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    Waypoint waypoint = path.get(next);
    double dx = waypoint.x() - targets.x(target);
    double dy = waypoint.y() - targets.y(target);
    double distance = Math.sqrt(dx * dx + dy * dy);
    double speed = Math.abs(targets.speed(target));
    if (distance <= speed) {
      targets.put(target, waypoint.x(), waypoint.y());
      next = (next + 1) % path.size();
    } else {
      targets.put(
          target,
          targets.x(target) + speed * dx / distance,
          targets.y(target) + speed * dy / distance);
    }
  }
}
