package org.hificamsim.tracks.mate;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Targets;

/**
 * What targets cannot pass in MATE's arena, though they can be seen through it: the obstacles, the
 * cameras, and the border of the field.
 */
record Walls(Field field, List<Obstacle.Pillar> discs) {
  private static final double CAMERA_RADIUS = 40;

  static Walls of(Scenario arena) {
    List<Obstacle.Pillar> discs = new ArrayList<>();
    arena.obstacles().forEach(one -> discs.add((Obstacle.Pillar) one));
    arena
        .cameras()
        .forEach(
            camera -> discs.add(new Obstacle.Pillar(camera.x(), camera.y(), CAMERA_RADIUS, 1)));
    return new Walls(arena.field(), List.copyOf(discs));
  }

  /** Puts a target where it comes to from a step: it slides along what is in its way. */
  void step(int target, Targets targets, double dx, double dy) {
    double x = targets.x(target) + dx;
    double y = targets.y(target) + dy;
    for (Obstacle.Pillar disc : discs) {
      double off = Math.hypot(x - disc.x(), y - disc.y());
      if (off < disc.radius() && off > 0) {
        x = disc.x() + (x - disc.x()) * disc.radius() / off;
        y = disc.y() + (y - disc.y()) * disc.radius() / off;
      }
    }
    targets.put(
        target,
        Math.max(field.minX(), Math.min(field.maxX(), x)),
        Math.max(field.minY(), Math.min(field.maxY(), y)));
  }
}
