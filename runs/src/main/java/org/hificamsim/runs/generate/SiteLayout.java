package org.hificamsim.runs.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.track.Track;

/**
 * Draws variants of a site: mirrored or not, with smaller obstacles, cameras moved and turned,
 * other paths of targets, and another part of a recording. No camera and no path of a variant is
 * inside an obstacle.
 *
 * <p>The hash of a benchmark's task depends on the names of this record's components.
 *
 * @param walls the largest share by which an obstacle may shrink, below 1
 * @param cameras the largest move of a camera in x and in y, in metres
 * @param turn the largest turn of a camera, in degrees
 * @param ways the largest distance in x and in y of a path's corner from a corner of the site,
 *     metres
 * @param training the first and last step of a recording at which training may begin; empty without
 *     a recording
 * @param testing the first and last step of a recording at which testing may begin
 */
public record SiteLayout(
    double walls,
    double cameras,
    double turn,
    double ways,
    List<Integer> training,
    List<Integer> testing) {
  private static final long SALT = 0x6265_6e63_685f_7631L;
  private static final int MAX_TRIES = 20;
  private static final int LEGS = 6;
  private static final int NEVER = Scenario.MAX_STEPS;

  /** Draws the variant of a site for a seed. */
  public Scenario draw(Scenario site, long seed, boolean isTesting) {
    return new VariantDrawing(site, new SplittableRandom(seed ^ SALT)).draw(isTesting);
  }

  /** Draws one variant. */
  private final class VariantDrawing {
    private final Scenario site;
    private final Field field;
    private final SplittableRandom random;
    private Obstacles obstacles;

    VariantDrawing(Scenario site, SplittableRandom random) {
      this.site = site;
      this.field = site.field();
      this.random = random;
    }

    Scenario draw(boolean isTesting) {
      Mirror mirror = new Mirror(field, random.nextBoolean(), random.nextBoolean());
      List<Obstacle> shrunk = site.obstacles().stream().map(this::shrunk).toList();
      obstacles = new Obstacles(shrunk);
      Scenario drawn =
          site.with(Scenario.OBSTACLES, shrunk)
              .withCameras(this::moved)
              .withTargets(this::withOtherPath);
      List<Integer> range = isTesting ? testing : training;
      Scenario mirrored = mirror.mirror(drawn);
      return range.isEmpty()
          ? mirrored
          : startingAt(mirrored, random.nextInt(range.get(0), range.get(1) + 1), mirror);
    }

    /** Draws a number from {@code -most} to {@code most}. */
    private double drawOffset(double most) {
      return most * (2 * random.nextDouble() - 1);
    }

    private Waypoint near(Waypoint position, double most) {
      return new Waypoint(position.x() + drawOffset(most), position.y() + drawOffset(most));
    }

    private Obstacle shrunk(Obstacle obstacle) {
      double factor = 1 - walls * random.nextDouble();
      List<Point> points =
          obstacle instanceof Obstacle.Polygon polygon
              ? polygon.points()
              : obstacle instanceof Obstacle.Wall wall
                  ? List.of(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()))
                  : List.of();
      double x = points.stream().mapToDouble(Point::x).average().orElse(0);
      double y = points.stream().mapToDouble(Point::y).average().orElse(0);
      double scale = points.isEmpty() ? 1 : factor; // the centre of a pillar stays
      return Mirror.moved(
          obstacle,
          factor,
          point -> new Waypoint(x + scale * (point.x() - x), y + scale * (point.y() - y)));
    }

    private boolean isFree(Waypoint position) {
      return field.contains(position.x(), position.y())
          && obstacles.containing(position.x(), position.y()).isEmpty();
    }

    private boolean hasClearPath(Waypoint from, Waypoint to) {
      return isFree(to) && obstacles.clear(from.x(), from.y(), to.x(), to.y());
    }

    /** Draws positions until one is suitable; returns the old one after too many tries. */
    private Waypoint drawn(Supplier<Waypoint> draw, Predicate<Waypoint> isSuitable, Waypoint old) {
      for (int i = 0; i < MAX_TRIES; i++) {
        Waypoint position = draw.get();
        if (isSuitable.test(position)) {
          return position;
        }
      }
      return old;
    }

    private CameraSpec moved(CameraSpec camera) {
      Waypoint old = new Waypoint(camera.x(), camera.y());
      Waypoint position =
          drawn(() -> near(old, cameras), candidate -> hasClearPath(old, candidate), old);
      return camera
          .with(CameraSpec.X, position.x())
          .with(CameraSpec.Y, position.y())
          .with(CameraSpec.HEADING, camera.heading() + drawOffset(turn));
    }

    private TargetSpec withOtherPath(TargetSpec target) {
      if (target.track().isPresent()) {
        return target;
      }
      List<Waypoint> path = target.waypoints().isEmpty() ? List.of() : path(target);
      Waypoint start =
          path.isEmpty()
              ? drawn(this::anywhere, this::isFree, new Waypoint(target.x(), target.y()))
              : path.get(0);
      return target
          .with(TargetSpec.X, start.x())
          .with(TargetSpec.Y, start.y())
          .with(TargetSpec.HEADING, 360 * random.nextDouble())
          .with(TargetSpec.SPEED, target.speed() * (1 + drawOffset(0.2)))
          .with(TargetSpec.WAYPOINTS, path);
    }

    private Waypoint anywhere() {
      return new Waypoint(
          field.minX() + field.width() * random.nextDouble(),
          field.minY() + field.height() * random.nextDouble());
    }

    /**
     * Draws a path and the way back, between corners of the paths that targets of the same width
     * have in the site.
     */
    private List<Waypoint> path(TargetSpec target) {
      List<Waypoint> corners =
          site.everyTarget()
              .filter(other -> other.width() == target.width())
              .flatMap(other -> other.waypoints().stream())
              .distinct()
              .filter(this::isFree)
              .toList();
      List<Waypoint> path = new ArrayList<>(List.of(corners.get(random.nextInt(corners.size()))));
      for (int leg = 0; leg < LEGS; leg++) {
        Waypoint last = path.get(leg);
        List<Waypoint> reachable =
            corners.stream()
                .filter(corner -> !corner.equals(last) && hasClearPath(last, corner))
                .toList();
        if (reachable.isEmpty()) {
          break;
        }
        Waypoint corner = reachable.get(random.nextInt(reachable.size()));
        path.add(
            drawn(() -> near(corner, ways), candidate -> hasClearPath(last, candidate), corner));
      }
      for (int back = path.size() - 2; back > 0; back--) {
        path.add(path.get(back));
      }
      return path.size() > 1 ? path : target.waypoints();
    }

    /** Cuts recorded targets at a first step; targets that have left before it never appear. */
    private Scenario startingAt(Scenario drawn, int begin, Mirror mirror) {
      List<ScenarioEvent> events = new ArrayList<>();
      for (ScenarioEvent event : drawn.events()) {
        if (event instanceof ScenarioEvent.AddTarget add) {
          Track old = add.target().track().orElseThrow();
          boolean hasLeft = old.lastStep() < begin;
          Track track = hasLeft ? old : old.from(begin * old.stepTime(), mirror::mirror);
          int step = hasLeft ? NEVER : (int) Math.max(0, track.firstStep());
          events.add(new ScenarioEvent.AddTarget(step, add.target().along(track)));
        } else if (event instanceof ScenarioEvent.RemoveTarget remove && remove.step() > begin) {
          events.add(new ScenarioEvent.RemoveTarget(remove.step() - begin, remove.features()));
        }
      }
      return drawn.with(Scenario.EVENTS, events);
    }
  }

  /**
   * Mirrors a site.
   *
   * @param eastWest whether east and west are swapped
   * @param northSouth whether north and south are swapped
   */
  private record Mirror(Field field, boolean eastWest, boolean northSouth) {
    Scenario mirror(Scenario site) {
      return site.with(
              Scenario.OBSTACLES,
              site.obstacles().stream().map(obstacle -> moved(obstacle, 1, this::mirror)).toList())
          .withCameras(this::mirror)
          .withTargets(this::mirror);
    }

    Point mirror(Point point) {
      Waypoint mirrored = mirror(new Waypoint(point.x(), point.y()));
      return new Point(mirrored.x(), mirrored.y());
    }

    Waypoint mirror(Waypoint position) {
      return new Waypoint(
          eastWest ? field.minX() + field.maxX() - position.x() : position.x(),
          northSouth ? field.minY() + field.maxY() - position.y() : position.y());
    }

    private double heading(double degrees) {
      double turned = northSouth ? 180 - degrees : degrees;
      return eastWest ? -turned : turned;
    }

    private CameraSpec mirror(CameraSpec camera) {
      Waypoint position = mirror(new Waypoint(camera.x(), camera.y()));
      return camera
          .with(CameraSpec.X, position.x())
          .with(CameraSpec.Y, position.y())
          .with(CameraSpec.HEADING, heading(camera.heading()));
    }

    private TargetSpec mirror(TargetSpec target) {
      Waypoint position = mirror(new Waypoint(target.x(), target.y()));
      return target
          .with(TargetSpec.X, position.x())
          .with(TargetSpec.Y, position.y())
          .with(TargetSpec.HEADING, heading(target.heading()))
          .with(TargetSpec.WAYPOINTS, target.waypoints().stream().map(this::mirror).toList());
    }

    /** Moves an obstacle's points, and multiplies its radius, if it has one, by a factor. */
    static Obstacle moved(Obstacle obstacle, double factor, UnaryOperator<Waypoint> move) {
      if (obstacle instanceof Obstacle.Pillar pillar) {
        Waypoint centre = move.apply(new Waypoint(pillar.x(), pillar.y()));
        return new Obstacle.Pillar(
            centre.x(),
            centre.y(),
            factor * pillar.radius(),
            pillar.transmittance(),
            pillar.base(),
            pillar.height());
      }
      if (obstacle instanceof Obstacle.Wall wall) {
        Waypoint from = move.apply(new Waypoint(wall.x1(), wall.y1()));
        Waypoint to = move.apply(new Waypoint(wall.x2(), wall.y2()));
        return new Obstacle.Wall(
            from.x(), from.y(), to.x(), to.y(), wall.transmittance(), wall.base(), wall.height());
      }
      Obstacle.Polygon polygon = (Obstacle.Polygon) obstacle;
      return new Obstacle.Polygon(
          polygon.points().stream()
              .map(point -> move.apply(new Waypoint(point.x(), point.y())))
              .map(corner -> new Point(corner.x(), corner.y()))
              .toList(),
          polygon.transmittance(),
          polygon.base(),
          polygon.height());
    }
  }
}
