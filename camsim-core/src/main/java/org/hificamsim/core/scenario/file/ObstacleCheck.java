package org.hificamsim.core.scenario.file;

import java.util.List;
import java.util.OptionalDouble;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Checks that cameras and targets stand outside all solid obstacles. */
public final class ObstacleCheck {
  private final Obstacles obstacles;

  public ObstacleCheck(List<Obstacle> obstacles) {
    this.obstacles = new Obstacles(obstacles);
  }

  /**
   * Checks the position of a camera, which may be above or below an obstacle if it has a height.
   */
  void requireFree(XmlElement element, double x, double y, OptionalDouble z) {
    require(element, x, y, obstacles.containing(x, y, z.orElse(0)).isPresent());
  }

  /** Checks a position; the error is at the attribute {@code x}. */
  void requireFree(XmlElement element, double x, double y) {
    require(element, x, y, obstacles.containing(x, y).isPresent());
  }

  private static void require(XmlElement element, double x, double y, boolean inside) {
    if (inside) {
      throw element.invalid(
          "x", "a place off all obstacles; (" + x + ", " + y + ") is in or on a solid one");
    }
  }

  /** Warns if the way around the waypoints leads through an obstacle. */
  void warnOfPath(XmlElement element, List<Waypoint> path) {
    for (int i = 0; i < path.size(); i++) {
      Waypoint from = path.get(i);
      Waypoint to = path.get((i + 1) % path.size());
      if (!obstacles.clear(from.x(), from.y(), to.x(), to.y())) {
        element.warn(
            Texts.format(
                "the way from (%s, %s) to (%s, %s) leads through a solid obstacle",
                from.x(), from.y(), to.x(), to.y()));
        return;
      }
    }
  }
}
