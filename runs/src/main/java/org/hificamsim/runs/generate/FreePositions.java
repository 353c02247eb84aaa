package org.hificamsim.runs.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DraftOptics;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * Draws cameras and people at positions outside all walls.
 *
 * @param zones the zones that contain the positions; empty for the whole field
 */
public record FreePositions(
    Field field, Obstacles obstacles, List<Zone> zones, SplittableRandom random) {
  /** The speed of people, metres a second. */
  private static final double MIN_SPEED = 0.8;

  private static final double MAX_SPEED = 1.6;
  private static final double CENTIMETRES_PER_METRE = 100;
  private static final int MAX_TRIES = 10_000;

  /**
   * Returns people who walk at random in the zones of a site, or in its field.
   *
   * @throws InputException if the site has no free place
   */
  public static List<TargetSpec> people(Scenario site, int count, long seed) {
    FreePositions positions =
        new FreePositions(
            site.field(),
            new Obstacles(site.obstacles()),
            site.zones(),
            new SplittableRandom(seed));
    return positions.draw(count, positions::person);
  }

  /**
   * Draws cameras or people.
   *
   * @param factory makes a camera or person of its number, from 1, and its position
   */
  <T> List<T> draw(int count, BiFunction<Integer, Point, T> factory) {
    List<T> drawn = new ArrayList<>();
    while (drawn.size() < count) {
      drawn.add(factory.apply(drawn.size() + 1, position()));
    }
    return drawn;
  }

  private Point position() {
    for (int i = 0; i < MAX_TRIES; i++) {
      double x = draw(field.minX(), field.maxX());
      double y = draw(field.minY(), field.maxY());
      if (obstacles.containing(x, y).isEmpty()
          && (zones.isEmpty() || zones.stream().anyMatch(zone -> zone.contains(x, y)))) {
        return new Point(x, y);
      }
    }
    throw new InputException("solids fill the field, expected room for people between them");
  }

  private double draw(double from, double to) {
    return rounded(random.nextDouble(from, to));
  }

  /** A length, rounded to centimetres. */
  static double rounded(double value) {
    return Math.rint(value * CENTIMETRES_PER_METRE) / CENTIMETRES_PER_METRE;
  }

  /** Makes a camera that looks towards a random point. */
  CameraSpec camera(int number, Point position) {
    return DraftOptics.camera(
        "C" + number,
        number % 4 == 0 ? DraftOptics.BULLET : DraftOptics.DOME,
        position.x(),
        position.y(),
        draw(field.minX(), field.maxX()),
        draw(field.minY(), field.maxY()));
  }

  TargetSpec person(int number, Point position) {
    return new TargetSpec(number, position.x(), position.y())
        .with(TargetSpec.MOVE, "RandomWaypoint")
        .with(TargetSpec.SPEED, draw(MIN_SPEED, MAX_SPEED))
        .withExtent(Extent.PERSON);
  }
}
