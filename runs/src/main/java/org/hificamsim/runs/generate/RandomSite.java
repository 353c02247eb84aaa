package org.hificamsim.runs.generate;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DraftOptics;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * A site made at random: cameras with lenses, three in four of which pan, people who walk from one
 * place to another, and walls.
 *
 * @param size how many cameras and people, on which area, from which seed
 * @param walls 0 or more
 */
public record RandomSite(RandomField size, int walls) {
  /** Square metres for each camera, as on a campus. */
  public static final double AREA = 2_400;

  private static final int STEPS = 300;
  private static final double PEOPLE_PER_CAMERA = 1.5;
  private static final Extent PERSON = new Extent(0.5, 1.75);
  private static final double SLOWEST = 0.8; // m/s
  private static final double FASTEST = 1.6;
  private static final double CENTI = 100;

  /** The usual size: one and a half people for each camera. */
  public static RandomField usual(int cameras, long seed) {
    int people = (int) Math.max(1, Math.round(PEOPLE_PER_CAMERA * cameras));
    return new RandomField(cameras, people, AREA, seed);
  }

  /**
   * The scenario, the same for the same arguments.
   *
   * @throws org.hificamsim.core.InputException when there is no room for the walls
   */
  public Scenario scenario() {
    Field exact = size.field();
    Field field = new Field(0, Math.ceil(exact.maxX()), 0, Math.ceil(exact.maxY()));
    SplittableRandom random = new SplittableRandom(size.seed());
    Obstacles obstacles =
        new Obstacles(new RandomWalls(field, Math.sqrt(size.area()), random).of(walls));
    Strewn strewn = new Strewn(field, obstacles, random);
    return new Scenario("random-" + size.cameras(), field)
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.DETECTION, "oodpcvs-2025:level=discern")
        .with(Scenario.OBJECTIVE, Objective.parse("covered:k=1"))
        .with(Scenario.STEPS, STEPS)
        .with(Scenario.OBSTACLES, obstacles.all())
        .with(Scenario.CAMERAS, strewn.all(size.cameras(), strewn::camera))
        .with(Scenario.TARGETS, strewn.all(size.targets(), strewn::person));
  }

  /** To the centimetre. */
  private static double metres(double value) {
    return Math.rint(value * CENTI) / CENTI;
  }

  /** What stands off all walls. */
  private record Strewn(Field field, Obstacles obstacles, SplittableRandom random) {
    <T> List<T> all(int count, BiFunction<Integer, double[], T> one) {
      List<T> all = new ArrayList<>();
      while (all.size() < count) {
        all.add(one.apply(all.size() + 1, free()));
      }
      return all;
    }

    private double[] free() {
      double[] at = {draw(field.minX(), field.maxX()), draw(field.minY(), field.maxY())};
      return obstacles.containing(at[0], at[1]).isEmpty() ? at : free();
    }

    private double draw(double from, double to) {
      return metres(random.nextDouble(from, to));
    }

    CameraSpec camera(int number, double[] at) {
      return DraftOptics.camera(
          "C" + number,
          number % 4 == 0 ? DraftOptics.BULLET : DraftOptics.DOME,
          at[0],
          at[1],
          draw(field.minX(), field.maxX()), // it looks at any place
          draw(field.minY(), field.maxY()));
    }

    TargetSpec person(int number, double[] at) {
      return new TargetSpec(number, at[0], at[1])
          .with(TargetSpec.MOVE, "RandomWaypoint")
          .with(TargetSpec.SPEED, draw(SLOWEST, FASTEST))
          .withExtent(PERSON);
    }
  }

  /**
   * Walls parallel to the sides of a field, at random places. They keep apart from each other and
   * from the field's borders, so that nothing is enclosed.
   */
  private static final class RandomWalls {
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
          "%s is %s, expected at most about %s in a field of %s x %s m",
          setting("walls"),
          count,
          walls.size(),
          Math.round(field.width()),
          Math.round(field.height()));
    }

    private Wall draw() {
      double x = metres(random.nextDouble(field.minX(), field.maxX()));
      double y = metres(random.nextDouble(field.minY(), field.maxY()));
      double length = metres(scale * random.nextDouble(SHORTEST, LONGEST));
      boolean along = random.nextBoolean();
      return new Wall(x, y, along ? metres(x + length) : x, along ? y : metres(y + length), 0);
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
}
