package org.hificamsim.tracks.mate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Targets;

/**
 * A random layout of MATE's arena for an episode. Cameras and obstacles stay in the parts of the
 * field where the scenario has them: in the corners' squares, at the edges, and in the middle.
 * Every second target is slow and carries twice as much.
 */
final class ArenaLayout {
  /** The difference between the angles of view of a lens, in degrees. */
  static final double ANGLE_STEP = 0.5;

  static final double NARROWEST_ANGLE = 30;
  static final double WIDEST_ANGLE = 180;

  private static final double SLOW_SPEED = 10;
  private static final double FAST_SPEED = 20;
  private static final double CAMERA_RADIUS = 40;
  private static final double MIDDLE = 200;
  private static final double CORNER = 800;
  private static final double EDGE = 900;
  private static final double BORDER = 1000;

  /** The distance between obstacles, and from obstacles to cameras: 42 in MATE's recordings. */
  private static final double GAP = 40;

  private final SplittableRandom random;

  /** The discs that targets cannot pass: first cameras, then obstacles. */
  private final List<Obstacle> discs = new ArrayList<>();

  private final Scenario scenario;
  private int targetCount;

  ArenaLayout(Scenario original, SplittableRandom random) {
    this.random = random;
    Scenario withCameras = original.withCameras(this::placed);
    original.obstacles().forEach(pillar -> discs.add(placed((Obstacle.Pillar) pillar)));
    scenario =
        withCameras
            .with(Scenario.OBSTACLES, discs.subList(original.cameras().size(), discs.size()))
            .withTargets(this::placed);
  }

  Scenario scenario() {
    return scenario;
  }

  /** A random number from -limit to limit. */
  private double within(double limit) {
    return limit * (2 * random.nextDouble() - 1);
  }

  /** A random number from least to greatest, with the sign of another one. */
  private double withSignOf(double original, double least, double greatest) {
    return Math.copySign(random.nextDouble(least, greatest), original);
  }

  private CameraSpec placed(CameraSpec camera) {
    double x = withSignOf(camera.x(), 500, CORNER);
    double y = withSignOf(camera.y(), 500, CORNER);
    discs.add(new Obstacle.Pillar(x, y, CAMERA_RADIUS, 1));
    OpticsSpec optics =
        camera
            .optics()
            .orElseThrow()
            .with(
                OpticsSpec.ANGLES_OF_VIEW,
                IntStream.rangeClosed(0, (int) ((WIDEST_ANGLE - NARROWEST_ANGLE) / ANGLE_STEP))
                    .mapToObj(level -> NARROWEST_ANGLE + level * ANGLE_STEP)
                    .toList())
            .with(OpticsSpec.PANS, List.of(0.0))
            .with(OpticsSpec.ZOOM_TIME, 0.0)
            .without(OpticsSpec.PAN_SPEED);
    return camera.with(CameraSpec.X, x).with(CameraSpec.Y, y).with(CameraSpec.OPTICS, optics);
  }

  private Obstacle placed(Obstacle.Pillar original) {
    boolean middle = Math.max(Math.abs(original.x()), Math.abs(original.y())) < MIDDLE;
    while (true) {
      double radius = random.nextDouble(25, 100);
      double x = coordinate(original.x(), original.y(), radius, middle);
      double y = coordinate(original.y(), original.x(), radius, middle);
      if (isFree(x, y, radius + GAP)) {
        return new Obstacle.Pillar(x, y, radius, original.transmittance());
      }
    }
  }

  /**
   * Returns a coordinate of an obstacle. At an edge, a fifth of the radius stays free, so that
   * targets can pass on both sides.
   *
   * @param original the coordinate in the scenario
   * @param perpendicular the other coordinate in the scenario
   */
  private double coordinate(double original, double perpendicular, double radius, boolean middle) {
    return Math.abs(original) == EDGE
        ? Math.copySign(Math.min(EDGE, BORDER - 1.2 * radius), original)
        : Math.abs(perpendicular) == EDGE
            ? within(500)
            : middle ? within(MIDDLE) : withSignOf(original, MIDDLE, CORNER);
  }

  private boolean isFree(double x, double y, double distance) {
    return discs.stream().allMatch(disc -> distance(disc, x, y) >= distance);
  }

  /** The distance of a point from the border of a disc, negative inside. */
  static double distance(Obstacle disc, double x, double y) {
    Obstacle.Pillar pillar = (Obstacle.Pillar) disc;
    return Math.hypot(x - pillar.x(), y - pillar.y()) - pillar.radius();
  }

  private TargetSpec placed(TargetSpec target) {
    double x;
    double y;
    do {
      x = within(MIDDLE);
      y = within(MIDDLE);
    } while (!isFree(x, y, 0));
    return target
        .withMovement(Freight.Carrier.NAME)
        .with(TargetSpec.X, x)
        .with(TargetSpec.Y, y)
        .with(TargetSpec.SPEED, targetCount++ % 2 == 0 ? FAST_SPEED : SLOW_SPEED);
  }

  /** Moves a target by a step; it slides along the discs in its way. */
  void step(int target, Targets targets, double dx, double dy) {
    double x = targets.x(target) + dx;
    double y = targets.y(target) + dy;
    for (Obstacle disc : discs) {
      double distance = distance(disc, x, y);
      if (distance < 0) {
        Obstacle.Pillar pillar = (Obstacle.Pillar) disc;
        double share = distance / (pillar.radius() + distance);
        x -= share * (x - pillar.x());
        y -= share * (y - pillar.y());
      }
    }
    targets.put(target, GreedyCameras.limited(x, BORDER), GreedyCameras.limited(y, BORDER));
  }
}
