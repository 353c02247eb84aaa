package org.hificamsim.runs.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.scenario.Field;

/**
 * Walls parallel to the sides of a field, at random places. They keep apart from each other and
 * from the field's borders, so that nothing is enclosed.
 */
final class RandomWalls {
  private static final double SHORTEST = 0.1; // of the scale, as the others
  private static final double LONGEST = 0.5;
  private static final double GAP = 0.04;
  private static final int TRIES = 1_000;

  private final Field field;
  private final double scale;
  private final SplittableRandom random;
  private final List<Wall> walls = new ArrayList<>();

  /**
   * @param scale the side of a camera's share of the field, metres
   */
  RandomWalls(Field field, double scale, SplittableRandom random) {
    this.field = field;
    this.scale = scale;
    this.random = random;
  }

  /**
   * This many walls.
   *
   * @throws InputException when there is no room for them
   */
  List<Obstacle> of(int count) {
    while (walls.size() < count) {
      add(count);
    }
    return List.copyOf(walls);
  }

  private void add(int count) {
    for (int i = 0; i < TRIES; i++) {
      Wall wall = draw();
      if (staysInside(wall) && walls.stream().allMatch(other -> apart(wall, other))) {
        walls.add(wall);
        return;
      }
    }
    throw InputException.of(
        "--walls is %s, expected at most about %s in a field of %s x %s m",
        count, walls.size(), Math.round(field.width()), Math.round(field.height()));
  }

  private Wall draw() {
    double x = RandomSite.metres(random.nextDouble(field.minX(), field.maxX()));
    double y = RandomSite.metres(random.nextDouble(field.minY(), field.maxY()));
    double length = RandomSite.metres(scale * random.nextDouble(SHORTEST, LONGEST));
    boolean along = random.nextBoolean();
    return new Wall(
        x,
        y,
        along ? RandomSite.metres(x + length) : x,
        along ? y : RandomSite.metres(y + length),
        0);
  }

  private boolean staysInside(Wall wall) {
    double gap = scale * GAP;
    return field.contains(wall.x1() - gap, wall.y1() - gap)
        && field.contains(wall.x2() + gap, wall.y2() + gap);
  }

  private boolean apart(Wall one, Wall other) {
    double gap = scale * GAP;
    return one.x1() > other.x2() + gap
        || other.x1() > one.x2() + gap
        || one.y1() > other.y2() + gap
        || other.y1() > one.y2() + gap;
  }
}
