package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;

/** Finds signs that walls are not where the recording has them. */
record WallSigns(ImportSummary summary, Obstacles obstacles) {
  /** The share of samples in an obstacle from which on it is taken for a walkable area. */
  private static final double NEARLY_ALL = 0.9;

  void addTo(Plausibility signs) {
    int samples = summary.way().points().size();
    long held = obstacles.all().stream().mapToLong(this::held).max().orElse(0);
    if (samples > 0 && held >= NEARLY_ALL * samples) {
      signs.fault(
          Texts.format(
              "a solid of the walls holds %.0f %% of the samples: it is probably the area that"
                  + " people walk in",
              100.0 * held / samples),
          setting("walkable") + ", which makes its border walls");
    } else if (summary.isEveryWayBlocked()) {
      signs.fault(
          "every way goes through a wall: walls and recording probably differ in unit or origin",
          Texts.format(
              "another %s, %s or %s", setting("walls_unit"), setting("scale"), setting("at")));
    }
  }

  private long held(Obstacle obstacle) {
    return obstacle instanceof Obstacle.Wall || !obstacle.standing()
        ? 0
        : summary.way().points().stream()
            .filter(point -> obstacle.contains(point.x(), point.y()))
            .count();
  }
}
