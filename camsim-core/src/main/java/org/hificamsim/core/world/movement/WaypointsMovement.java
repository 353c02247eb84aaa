package org.hificamsim.core.world.movement;

import java.util.List;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Waypoint;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * CamSim's waypoints: always a full step towards the current waypoint; within 0.99999 m of it the
 * target turns to the next one, cyclically, so that it never stands on one exactly. It starts on
 * the first where waypoints alone ask for this movement, and where the scenario puts it where a
 * name does (behaviour 3.5, 5.1).
 */
final class WaypointsMovement implements Movement {
  private static final double NEAR = 1 - 0.00001;

  /** East, which CamSim asks for as atan2(1, 0) each time: the same number. */
  private static final double EAST = Math.PI / 2;

  private List<Waypoint> path;
  private int next = 1;

  @Override
  public String name() {
    return "Waypoints";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    path = spec.waypoints();
    if (spec.get(TargetSpec.MOVE).isEmpty()) {
      targets.put(target, path.get(0).x(), path.get(0).y());
    }
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    double x = targets.x(target);
    double y = targets.y(target);
    if (distance(x - path.get(next).x(), y - path.get(next).y()) < NEAR) {
      next = (next + 1) % path.size();
    }
    Waypoint waypoint = path.get(next);
    targets.turnTo(target, EAST - Math.atan2(waypoint.y() - y, waypoint.x() - x));
    double dx = Math.sin(targets.heading(target)) * targets.speed(target);
    double dy = Math.cos(targets.heading(target)) * targets.speed(target);
    targets.advance(target, dx, dy, random.turn());
  }

  private static double distance(double dx, double dy) {
    return Math.sqrt(dx * dx + dy * dy);
  }
}
