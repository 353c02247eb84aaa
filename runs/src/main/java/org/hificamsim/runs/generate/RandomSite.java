package org.hificamsim.runs.generate;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;

/**
 * Generates a random site: cameras with lenses, three in four of which pan, people who walk between
 * random positions, and walls.
 *
 * @param size the numbers of cameras and people, the area and the seed
 * @param walls the number of walls, 0 or more
 */
public record RandomSite(RandomField size, int walls) {
  /** The area for each camera, as on a campus, in square metres. */
  public static final double AREA = 2_400;

  private static final int STEPS = 300;
  private static final double PEOPLE_PER_CAMERA = 1.5;

  /** Returns the default size, which has one and a half people for each camera. */
  public static RandomField size(int cameras, long seed) {
    int people = (int) Math.max(1, Math.round(PEOPLE_PER_CAMERA * cameras));
    return new RandomField(cameras, people, AREA, seed);
  }

  /**
   * Generates the scenario, which is the same for the same arguments.
   *
   * @throws org.hificamsim.core.InputException when there is no room for the walls
   */
  public Scenario scenario() {
    Field exact = size.field();
    Field field = new Field(0, Math.ceil(exact.maxX()), 0, Math.ceil(exact.maxY()));
    SplittableRandom random = new SplittableRandom(size.seed());
    Obstacles obstacles =
        new Obstacles(new RandomWalls(field, Math.sqrt(size.area()), random).draw(walls));
    FreePositions positions = new FreePositions(field, obstacles, List.of(), random);
    return new Scenario("random-" + size.cameras(), field)
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.DETECTION, "oodpcvs-2025:level=discern")
        .with(Scenario.OBJECTIVE, Objective.parse("covered:k=1"))
        .with(Scenario.STEPS, STEPS)
        .with(Scenario.OBSTACLES, obstacles.all())
        .with(Scenario.CAMERAS, positions.draw(size.cameras(), positions::camera))
        .with(Scenario.TARGETS, positions.draw(size.targets(), positions::person));
  }

  /**
   * Draws walls at random positions, parallel to the sides of the field. They keep a distance from
   * each other and from the borders, so that nothing is enclosed.
   */
  private static final class RandomWalls {
    private static final double MIN_LENGTH_PER_SCALE = 0.1;
    private static final double MAX_LENGTH_PER_SCALE = 0.5;
    private static final double GAP_PER_SCALE = 0.04;
    private static final int MAX_TRIES_PER_WALL = 1_000;

    private final Field field;
    private final double scale;
    private final SplittableRandom random;
    private final List<Wall> walls = new ArrayList<>();

    /**
     * @param scale the side of a square with the area for one camera, in metres
     */
    RandomWalls(Field field, double scale, SplittableRandom random) {
      this.field = field;
      this.scale = scale;
      this.random = random;
    }

    /**
     * Draws walls.
     *
     * @throws InputException when there is no room for them
     */
    List<Obstacle> draw(int count) {
      while (walls.size() < count) {
        add(count);
      }
      return List.copyOf(walls);
    }

    private void add(int count) {
      for (int i = 0; i < MAX_TRIES_PER_WALL; i++) {
        Wall wall = draw();
        if (staysInside(wall) && walls.stream().allMatch(other -> areApart(wall, other))) {
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
      double x = FreePositions.rounded(random.nextDouble(field.minX(), field.maxX()));
      double y = FreePositions.rounded(random.nextDouble(field.minY(), field.maxY()));
      double length =
          FreePositions.rounded(
              scale * random.nextDouble(MIN_LENGTH_PER_SCALE, MAX_LENGTH_PER_SCALE));
      boolean isHorizontal = random.nextBoolean();
      return new Wall(
          x,
          y,
          isHorizontal ? FreePositions.rounded(x + length) : x,
          isHorizontal ? y : FreePositions.rounded(y + length),
          0);
    }

    private boolean staysInside(Wall wall) {
      double gap = scale * GAP_PER_SCALE;
      return field.contains(wall.x1() - gap, wall.y1() - gap)
          && field.contains(wall.x2() + gap, wall.y2() + gap);
    }

    private boolean areApart(Wall first, Wall second) {
      double gap = scale * GAP_PER_SCALE;
      return first.x1() > second.x2() + gap
          || second.x1() > first.x2() + gap
          || first.y1() > second.y2() + gap
          || second.y1() > first.y2() + gap;
    }
  }
}
