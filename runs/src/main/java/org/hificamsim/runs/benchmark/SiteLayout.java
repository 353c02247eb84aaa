package org.hificamsim.runs.benchmark;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Predicate;
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
 * How a site is drawn anew by a seed: in a mirror or not, with smaller obstacles, cameras
 * elsewhere, other ways, and another time of a recording. What is drawn never stands or walks in an
 * obstacle.
 *
 * @param walls by what part an obstacle may be smaller, below 1
 * @param cameras how far a camera may be moved in x and in y, metres
 * @param turn how far it may be turned, degrees
 * @param ways how far a corner of a way may be off a corner of the site's own, metres
 * @param training first and last step at which a recording may begin; empty without one
 * @param testing the same for testing
 */
record SiteLayout(
    double walls,
    double cameras,
    double turn,
    double ways,
    List<Integer> training,
    List<Integer> testing) {
  private static final long SALT = 0x6265_6e63_685f_7631L;
  private static final int TRIES = 20;
  private static final int LEGS = 6;
  private static final int NEVER = Scenario.MAX_STEPS;

  /** The site as a seed has it. */
  Scenario draw(Scenario site, long seed, boolean isTesting) {
    return new Drawing(site, new SplittableRandom(seed ^ SALT)).site(isTesting);
  }

  private final class Drawing {
    private final Scenario site;
    private final Field field;
    private final SplittableRandom random;
    private Obstacles obstacles;

    Drawing(Scenario site, SplittableRandom random) {
      this.site = site;
      this.field = site.field();
      this.random = random;
    }

    Scenario site(boolean isTesting) {
      Mirror mirror = new Mirror(field, random.nextBoolean(), random.nextBoolean());
      List<Obstacle> smaller = site.obstacles().stream().map(this::smaller).toList();
      obstacles = new Obstacles(smaller);
      Scenario drawn =
          site.with(Scenario.OBSTACLES, smaller)
              .withCameras(this::elsewhere)
              .withTargets(this::way);
      List<Integer> begins = isTesting ? testing : training;
      Scenario mirrored = mirror.of(drawn);
      return begins.isEmpty()
          ? mirrored
          : from(mirrored, random.nextInt(begins.get(0), begins.get(1) + 1), mirror);
    }

    private double off(double most) {
      return most * (2 * random.nextDouble() - 1);
    }

    private Waypoint near(double x, double y, double most) {
      return new Waypoint(x + off(most), y + off(most));
    }

    private Obstacle smaller(Obstacle one) {
      double part = 1 - walls * random.nextDouble();
      List<Point> points =
          one instanceof Obstacle.Polygon polygon
              ? polygon.points()
              : one instanceof Obstacle.Wall wall
                  ? List.of(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()))
                  : List.of();
      double x = points.stream().mapToDouble(Point::x).average().orElse(0);
      double y = points.stream().mapToDouble(Point::y).average().orElse(0);
      double left = points.isEmpty() ? 1 : part; // a pillar stays where it is
      return Mirror.moved(
          one, part, to -> new Waypoint(x + left * (to.x() - x), y + left * (to.y() - y)));
    }

    private boolean isFree(Waypoint place) {
      return field.contains(place.x(), place.y())
          && obstacles.containing(place.x(), place.y()).isEmpty();
    }

    private boolean isClear(Waypoint from, Waypoint to) {
      return isFree(to) && obstacles.clear(from.x(), from.y(), to.x(), to.y());
    }

    /** The first of some draws that will do, else what there was. */
    private Waypoint drawn(UnaryOperator<Waypoint> draw, Predicate<Waypoint> will, Waypoint old) {
      for (int i = 0; i < TRIES; i++) {
        Waypoint one = draw.apply(old);
        if (will.test(one)) {
          return one;
        }
      }
      return old;
    }

    private CameraSpec elsewhere(CameraSpec camera) {
      Waypoint old = new Waypoint(camera.x(), camera.y());
      Waypoint to = drawn(one -> near(one.x(), one.y(), cameras), one -> isClear(old, one), old);
      return camera
          .with(CameraSpec.X, to.x())
          .with(CameraSpec.Y, to.y())
          .with(CameraSpec.HEADING, camera.heading() + off(turn));
    }

    private TargetSpec way(TargetSpec target) {
      if (target.track().isPresent()) {
        return target;
      }
      List<Waypoint> way = target.waypoints().isEmpty() ? List.of() : corners(target);
      Waypoint start =
          way.isEmpty()
              ? drawn(any -> anywhere(), this::isFree, new Waypoint(target.x(), target.y()))
              : way.get(0);
      return target
          .with(TargetSpec.X, start.x())
          .with(TargetSpec.Y, start.y())
          .with(TargetSpec.HEADING, 360 * random.nextDouble())
          .with(TargetSpec.SPEED, target.speed() * (1 + off(0.2)))
          .with(TargetSpec.WAYPOINTS, way);
    }

    private Waypoint anywhere() {
      return new Waypoint(
          field.minX() + field.width() * random.nextDouble(),
          field.minY() + field.height() * random.nextDouble());
    }

    /** From corner to corner of those that targets as wide as this one have, and back again. */
    private List<Waypoint> corners(TargetSpec target) {
      List<Waypoint> all =
          site.everyTarget()
              .filter(other -> other.width() == target.width())
              .flatMap(other -> other.waypoints().stream())
              .distinct()
              .filter(this::isFree)
              .toList();
      List<Waypoint> way = new ArrayList<>(List.of(all.get(random.nextInt(all.size()))));
      for (int leg = 0; leg < LEGS; leg++) {
        Waypoint at = way.get(leg);
        List<Waypoint> next =
            all.stream().filter(one -> !one.equals(at) && isClear(at, one)).toList();
        if (next.isEmpty()) {
          break;
        }
        Waypoint corner = next.get(random.nextInt(next.size()));
        way.add(drawn(any -> near(corner.x(), corner.y(), ways), one -> isClear(at, one), corner));
      }
      for (int back = way.size() - 2; back > 0; back--) {
        way.add(way.get(back));
      }
      return way.size() > 1 ? way : target.waypoints();
    }

    /** Recorded targets from a step on; those that have gone by then never come. */
    private Scenario from(Scenario drawn, int begin, Mirror mirror) {
      List<ScenarioEvent> events = new ArrayList<>();
      for (ScenarioEvent event : drawn.events()) {
        if (event instanceof ScenarioEvent.AddTarget add) {
          Track old = add.target().track().orElseThrow();
          boolean gone = old.lastStep() < begin;
          Track track = gone ? old : old.from(begin * old.stepTime(), mirror::of);
          int step = gone ? NEVER : (int) Math.max(0, track.firstStep());
          events.add(new ScenarioEvent.AddTarget(step, add.target().along(track)));
        } else if (event instanceof ScenarioEvent.RemoveTarget remove && remove.step() > begin) {
          events.add(new ScenarioEvent.RemoveTarget(remove.step() - begin, remove.features()));
        }
      }
      return drawn.with(Scenario.EVENTS, events);
    }
  }

  /**
   * A site seen in a mirror.
   *
   * @param east whether east and west change places
   * @param north whether north and south do
   */
  private record Mirror(Field field, boolean east, boolean north) {
    Scenario of(Scenario site) {
      return site.with(
              Scenario.OBSTACLES,
              site.obstacles().stream().map(one -> moved(one, 1, this::of)).toList())
          .withCameras(this::of)
          .withTargets(this::of);
    }

    Point of(Point point) {
      Waypoint place = of(new Waypoint(point.x(), point.y()));
      return new Point(place.x(), place.y());
    }

    Waypoint of(Waypoint place) {
      return new Waypoint(
          east ? field.minX() + field.maxX() - place.x() : place.x(),
          north ? field.minY() + field.maxY() - place.y() : place.y());
    }

    private double heading(double degrees) {
      double turned = north ? 180 - degrees : degrees;
      return east ? -turned : turned;
    }

    private CameraSpec of(CameraSpec camera) {
      Waypoint place = of(new Waypoint(camera.x(), camera.y()));
      return camera
          .with(CameraSpec.X, place.x())
          .with(CameraSpec.Y, place.y())
          .with(CameraSpec.HEADING, heading(camera.heading()));
    }

    private TargetSpec of(TargetSpec target) {
      Waypoint place = of(new Waypoint(target.x(), target.y()));
      return target
          .with(TargetSpec.X, place.x())
          .with(TargetSpec.Y, place.y())
          .with(TargetSpec.HEADING, heading(target.heading()))
          .with(TargetSpec.WAYPOINTS, target.waypoints().stream().map(this::of).toList());
    }

    /** An obstacle whose points are moved, and of whose radius a part is left. */
    static Obstacle moved(Obstacle obstacle, double part, UnaryOperator<Waypoint> move) {
      if (obstacle instanceof Obstacle.Pillar one) {
        Waypoint to = move.apply(new Waypoint(one.x(), one.y()));
        return new Obstacle.Pillar(
            to.x(), to.y(), part * one.radius(), one.transmittance(), one.base(), one.height());
      }
      if (obstacle instanceof Obstacle.Wall one) {
        Waypoint from = move.apply(new Waypoint(one.x1(), one.y1()));
        Waypoint to = move.apply(new Waypoint(one.x2(), one.y2()));
        return new Obstacle.Wall(
            from.x(), from.y(), to.x(), to.y(), one.transmittance(), one.base(), one.height());
      }
      Obstacle.Polygon one = (Obstacle.Polygon) obstacle;
      return new Obstacle.Polygon(
          one.points().stream()
              .map(point -> move.apply(new Waypoint(point.x(), point.y())))
              .map(to -> new Point(to.x(), to.y()))
              .toList(),
          one.transmittance(),
          one.base(),
          one.height());
    }
  }
}
