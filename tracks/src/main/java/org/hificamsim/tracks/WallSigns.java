package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;

/** Finds signs that the walls do not fit the recording. */
record WallSigns(ImportSummary summary, Obstacles obstacles) {
  /**
   * The share of the samples from which an obstacle that contains them is probably a walkable area.
   */
  static final double NEARLY_ALL = 0.9;

  void addTo(Plausibility signs) {
    double shareInSolid = shareInSolid(obstacles, summary.positions().points());
    if (shareInSolid >= NEARLY_ALL) {
      signs.fault(
          Texts.format(
              "a solid of the walls holds %.0f %% of the samples: it is probably the area that"
                  + " people walk in",
              100 * shareInSolid),
          setting("walkable") + ", which makes its border walls");
    } else if (summary.isEveryTrackBlocked()) {
      signs.fault(
          "every way goes through a wall: walls and recording probably differ in unit or origin",
          Texts.format(
              "another %s, %s or %s", setting("walls_unit"), setting("scale"), setting("at")));
    }
  }

  /** The greatest share of points that lie in the same solid. */
  static double shareInSolid(Obstacles obstacles, List<Point> points) {
    long most =
        obstacles.all().stream()
            .filter(obstacle -> obstacle.standing() && !(obstacle instanceof Obstacle.Wall))
            .mapToLong(
                solid ->
                    points.stream().filter(point -> solid.contains(point.x(), point.y())).count())
            .max()
            .orElse(0);
    return points.isEmpty() ? 0 : (double) most / points.size();
  }
}
