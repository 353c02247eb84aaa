package org.hificamsim.tracks.mate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;

/**
 * MATE's arena as it is drawn for an episode: cameras and obstacles within the bounds of those of
 * the site, which are in the corners' squares, at the field's edges and in the middle. Every second
 * target is slow, and carries twice as much.
 */
final class ArenaLayout {
  /** Angles of view that a lens stops at, degrees apart. */
  static final double LEVEL = 0.5;

  static final double NARROWEST = 30;
  static final double WIDEST = 180;

  private static final double MIDDLE = 200;
  private static final double EDGE = 900;
  private static final double ALONG_EDGE = 500;
  private static final double CORNER = 800;
  private static final double CAMERA_FROM = 500;
  private static final double LEAST_RADIUS = 25;
  private static final double MOST_RADIUS = 100;
  private static final double SLOW = 10;
  private static final double FAST = 20;

  /** What is free between a camera and an obstacle; 82 is the least in MATE's recordings. */
  private static final double FREE = 80;

  /** The same between two obstacles; 44 is the least there. */
  private static final double GAP = 40;

  /** How far a target may be from the middle, and how far an obstacle is off that, in radii. */
  private static final double BORDER = 1000;

  private static final double OFF_BORDER = 1.2;

  private final SplittableRandom random;

  private ArenaLayout(SplittableRandom random) {
    this.random = random;
  }

  static Scenario draw(Scenario site, SplittableRandom random) {
    return new ArenaLayout(random).draw(site);
  }

  private Scenario draw(Scenario site) {
    Scenario mounted = site.withCameras(this::mounted);
    List<Obstacle.Pillar> drawn = new ArrayList<>();
    for (Obstacle old : site.obstacles()) {
      drawn.add(free((Obstacle.Pillar) old, mounted.cameras(), drawn));
    }
    double[] speed = {SLOW};
    return mounted
        .with(Scenario.OBSTACLES, List.<Obstacle>copyOf(drawn))
        .withTargets(
            target -> {
              speed[0] = SLOW + FAST - speed[0];
              return started(target, drawn).with(TargetSpec.SPEED, speed[0]);
            });
  }

  /** A number from -most to most. */
  private double within(double most) {
    return most * (2 * random.nextDouble() - 1);
  }

  /** A number on the same side of 0. */
  private double beside(double old, double least, double most) {
    return Math.copySign(least + (most - least) * random.nextDouble(), old);
  }

  private CameraSpec mounted(CameraSpec camera) {
    OpticsSpec optics =
        camera
            .optics()
            .orElseThrow()
            .with(OpticsSpec.ANGLES_OF_VIEW, angles())
            .with(OpticsSpec.PANS, List.of(0.0))
            .with(OpticsSpec.ZOOM_TIME, 0.0)
            .without(OpticsSpec.PAN_SPEED);
    return camera
        .with(CameraSpec.X, beside(camera.x(), CAMERA_FROM, CORNER))
        .with(CameraSpec.Y, beside(camera.y(), CAMERA_FROM, CORNER))
        .with(CameraSpec.OPTICS, optics);
  }

  private static List<Double> angles() {
    return IntStream.rangeClosed(0, (int) ((WIDEST - NARROWEST) / LEVEL))
        .mapToObj(level -> NARROWEST + level * LEVEL)
        .toList();
  }

  private Obstacle.Pillar free(
      Obstacle.Pillar old, List<CameraSpec> cameras, List<Obstacle.Pillar> others) {
    Obstacle.Pillar drawn;
    do {
      double radius = LEAST_RADIUS + (MOST_RADIUS - LEAST_RADIUS) * random.nextDouble();
      boolean middle = Math.max(Math.abs(old.x()), Math.abs(old.y())) < MIDDLE;
      double x = place(old.x(), old.y(), radius, middle);
      double y = place(old.y(), old.x(), radius, middle);
      drawn = new Obstacle.Pillar(x, y, radius, old.transmittance());
    } while (!isFree(drawn, cameras, others));
    return drawn;
  }

  private double place(double old, double other, double radius, boolean middle) {
    return Math.abs(old) == EDGE
        ? Math.copySign(Math.min(EDGE, BORDER - OFF_BORDER * radius), old)
        : Math.abs(other) == EDGE
            ? within(ALONG_EDGE)
            : middle ? within(MIDDLE) : beside(old, MIDDLE, CORNER);
  }

  private static boolean isFree(
      Obstacle.Pillar disc, List<CameraSpec> cameras, List<Obstacle.Pillar> others) {
    return cameras.stream().allMatch(one -> off(disc, one.x(), one.y()) >= FREE)
        && others.stream().allMatch(one -> off(disc, one.x(), one.y()) >= one.radius() + GAP);
  }

  /** How far a point is off a disc. */
  private static double off(Obstacle.Pillar disc, double x, double y) {
    return Math.hypot(disc.x() - x, disc.y() - y) - disc.radius();
  }

  private TargetSpec started(TargetSpec target, List<Obstacle.Pillar> obstacles) {
    double x;
    double y;
    do {
      x = within(MIDDLE);
      y = within(MIDDLE);
    } while (touches(obstacles, x, y));
    return target.withMovement(Carrier.NAME).with(TargetSpec.X, x).with(TargetSpec.Y, y);
  }

  private static boolean touches(List<Obstacle.Pillar> obstacles, double x, double y) {
    return obstacles.stream().anyMatch(one -> off(one, x, y) <= 0);
  }
}
