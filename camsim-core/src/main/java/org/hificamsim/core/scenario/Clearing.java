package org.hificamsim.core.scenario;

import java.util.List;
import java.util.function.Consumer;
import org.hificamsim.core.obstacle.Obstacles;

/** Says where cameras and targets may stand: in no solid obstacle, nor on its border. */
final class Clearing {
  private final Obstacles obstacles;
  private final Consumer<String> warnings;

  Clearing(Surroundings surroundings, Consumer<String> warnings) {
    this.obstacles = new Obstacles(surroundings.obstacles());
    this.warnings = warnings;
  }

  /** An error at the attribute {@code x} for what stands in an obstacle. */
  void requireFree(Attributes attributes, double x, double y) {
    if (obstacles.containing(x, y).isPresent()) {
      throw attributes.invalid(
          "x", "a place off all obstacles; (" + x + ", " + y + ") is in or on a solid one");
    }
  }

  /** A warning where the way around the waypoints leads through an obstacle. */
  void warnOfPath(XmlElement element, List<Waypoint> path) {
    for (int i = 0; i < path.size(); i++) {
      Waypoint from = path.get(i);
      Waypoint to = path.get((i + 1) % path.size());
      if (!obstacles.clear(from.x(), from.y(), to.x(), to.y())) {
        warnings.accept(
            element.place()
                + ": the way from ("
                + from.x()
                + ", "
                + from.y()
                + ") to ("
                + to.x()
                + ", "
                + to.y()
                + ") leads through a solid obstacle");
        return;
      }
    }
  }
}
