package org.hificamsim.core.world.movement;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.scenario.track.TrackWalk;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/** The movements that come with the simulator. */
public final class Movements {
  private Movements() {}

  /** Adds the built-in movements to a registry. */
  public static Registry<Movement> register(Registry<Movement> registry) {
    return registry
        .register("Straight", "straight line, turning at the border", Straight::new)
        .register("Waypoints", "CamSim's closed path, full steps", Waypoints::new)
        .register("Scripted", "the coverage study's closed path, exact", Scripted::new)
        .register("Brownian", "random walk of given mean and std", Brownian::new)
        .register("DirectedBrownian", "wandering line", DirectedBrownian::new)
        .register(
            "RandomWaypoint",
            "straight to random places, around obstacles",
            RandomWaypointMovement::new)
        .register("Tracks", "recorded tracks, of a <tracks> element", Tracks::new);
  }

  /** A registry of the built-in movements and those in users' jars. */
  public static Registry<Movement> registry() {
    return register(new Registry<>("movement"))
        .registerServices(Movement.class, Movement::name, (movement, options) -> {});
  }

  /** A straight line at constant speed, turning at the border (Eq 3.3). */
  private static final class Straight implements Movement {
    private double dx;
    private double dy;

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      face(target, targets);
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      if (!targets.advance(target, dx, dy, random.turn())) {
        face(target, targets);
      }
    }

    private void face(int target, Targets targets) {
      dx = Math.sin(targets.heading(target)) * targets.speed(target);
      dy = Math.cos(targets.heading(target)) * targets.speed(target);
    }
  }

  /**
   * CamSim's waypoints: the target always takes a full step towards the current waypoint; within
   * 0.99999 m of it, it turns to the next one, cyclically, and so never stands on one exactly. It
   * starts at its own position, or on the first waypoint if the file names no movement (behaviour
   * 3.5, 5.1).
   */
  private static final class Waypoints implements Movement {
    private static final double NEAR = 1 - 0.00001;

    /** The heading of east; CamSim computes the same number as atan2(1, 0). */
    private static final double EAST = Math.PI / 2;

    private List<Waypoint> path;
    private int next = 1;

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      path = spec.waypoints();
      if (spec.get(TargetSpec.MOVE).isEmpty()) {
        targets.put(target, path.get(0).x(), path.get(0).y());
      }
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      double x = targets.x(target);
      double y = targets.y(target);
      if (distance(x - path.get(next).x(), y - path.get(next).y()) < NEAR) {
        next = (next + 1) % path.size();
      }
      Waypoint waypoint = path.get(next);
      targets.turnTo(target, EAST - Math.atan2(waypoint.y() - y, waypoint.x() - x));
      double dx = Math.sin(targets.heading(target)) * targets.speed(target);
      double dy = Math.cos(targets.heading(target)) * targets.speed(target);
      targets.advance(target, dx, dy, random.turn());
    }

    private static double distance(double dx, double dy) {
      return Math.sqrt(dx * dx + dy * dy);
    }
  }

  /**
   * The coverage study's waypoints: the target starts on the first one and walks towards the next;
   * a waypoint within one step is reached exactly, and the target turns to the one after,
   * cyclically. A negative speed counts as its absolute value, since the target would never arrive.
   */
  private static final class Scripted implements Movement {
    private List<Waypoint> path;
    private int next = 1;

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      path = spec.waypoints();
      targets.put(target, path.get(0).x(), path.get(0).y());
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      Waypoint waypoint = path.get(next);
      double dx = waypoint.x() - targets.x(target);
      double dy = waypoint.y() - targets.y(target);
      double distance = Math.sqrt(dx * dx + dy * dy);
      double speed = Math.abs(targets.speed(target));
      if (distance <= speed) {
        targets.put(target, waypoint.x(), waypoint.y());
        next = (next + 1) % path.size();
      } else {
        targets.put(
            target,
            targets.x(target) + speed * dx / distance,
            targets.y(target) + speed * dy / distance);
      }
    }
  }

  /** CamSim's plain random walk: each coordinate moves by a gaussian of the given mean and std. */
  private static final class Brownian implements Movement {
    private double mean;
    private double std;

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      mean = spec.mean();
      std = spec.std();
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      double dx = mean + random.move().nextGaussian() * std;
      double dy = mean + random.move().nextGaussian() * std;
      targets.advance(target, dx, dy, random.turn());
    }
  }

  /**
   * CamSim's wandering line: speed changes by a tenth of a gaussian, heading by half of one, then a
   * straight step. The speed may become negative; mean and std are not used.
   */
  private static final class DirectedBrownian implements Movement {
    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      double forSpeed = random.move().nextGaussian();
      double forHeading = random.move().nextGaussian();
      targets.accelerateTo(target, targets.speed(target) + forSpeed / 10);
      targets.turnTo(target, targets.heading(target) + forHeading / 2);
      double dx = Math.sin(targets.heading(target)) * targets.speed(target);
      double dy = Math.cos(targets.heading(target)) * targets.speed(target);
      targets.advance(target, dx, dy, random.turn());
    }
  }

  /**
   * A recorded track: when cameras look in step n, the target is where it was at time n times the
   * length of a step, interpolated between two samples, even through obstacles. At the end of the
   * track it stays until it is removed. Heading and speed stay those of its start: computing them
   * would take longer than the step, and nothing uses them.
   */
  private static final class Tracks implements Movement {
    private final TrackWalk walk = new TrackWalk();

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      if (spec.track().isEmpty()) { // not a lambda, which would allocate
        throw InputException.of(
            "target %s moves by Tracks and has no track, expected one of <tracks>", spec.name());
      }
      Track track = spec.track().get();
      walk.begin(track, track.firstStep() - (targets.moveFirst() ? 1 : 0));
      targets.put(target, walk.x(), walk.y());
    }

    @Override
    public void move(int target, Targets targets, RandomStreams random) {
      walk.next();
      targets.put(target, walk.x(), walk.y());
    }
  }
}
