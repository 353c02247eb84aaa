package org.hificamsim.presentation.view;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * The demand of a zone that is being drawn.
 *
 * @param name the name of the zone; empty for any free name
 * @param detection the detection by which cameras must see there
 * @param k the number of cameras that must see there
 * @param facing the heading of the faces that have to be seen, in degrees; null for any
 * @param maxDepression the steepest view down at a face, in degrees; null for any
 */
record ZoneDraft(String name, String detection, int k, Double facing, Double maxDepression) {
  private static final int MAX_K = 100;
  private static final double FULL_TURN = 360;
  private static final double RIGHT_ANGLE = 90;
  private static final double LEAST_DEPRESSION = 0.1;

  /**
   * Returns the zone between two opposite corners.
   *
   * @throws InputException if it has no area or an invalid requirement
   */
  Zone between(Point corner, Point opposite) {
    Ranges.within("k", k, 1, MAX_K);
    if (facing != null) {
      Ranges.within("facing", facing, -FULL_TURN, FULL_TURN);
    }
    if (maxDepression != null) {
      Ranges.within("max_depression", maxDepression, LEAST_DEPRESSION, RIGHT_ANGLE);
    }
    if (corner.x() == opposite.x() || corner.y() == opposite.y()) {
      throw new InputException("the zone has no area, expected two opposite corners");
    }
    return new Zone(
        name,
        Zone.Shape.RECTANGLE,
        List.of(corner, opposite),
        detection,
        k,
        1.0,
        facing,
        null,
        maxDepression);
  }
}
