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
 * MATE's arena as it is drawn for an episode: cameras and obstacles within the bounds of those of
 * the site, which are in the corners' squares, at the field's edges and in the middle. Every second
 * target is slow, and carries twice as much.
 */
final class ArenaLayout {
  /** Angles of view that a lens stops at, degrees apart. */
  static final double LEVEL = 0.5;

  static final double NARROWEST = 30;
  static final double WIDEST = 180;

  private static final double SLOW = 10;
  private static final double FAST = 20;
  private static final double CAMERA_RADIUS = 40;
  private static final double MIDDLE = 200;
  private static final double CORNER = 800;
  private static final double EDGE = 900;
  private static final double BORDER = 1000;

  /** What is free between two obstacles, or between one and a camera: 42 in MATE's recordings. */
  private static final double GAP = 40;

  private final SplittableRandom random;

  /** What targets cannot pass, though they can be seen through it: cameras, then obstacles. */
  private final List<Obstacle> discs = new ArrayList<>();

  private final Scenario drawn;
  private int started;

  ArenaLayout(Scenario site, SplittableRandom random) {
    this.random = random;
    Scenario mounted = site.withCameras(this::mounted);
    site.obstacles().forEach(old -> discs.add(free((Obstacle.Pillar) old)));
    drawn =
        mounted
            .with(Scenario.OBSTACLES, discs.subList(site.cameras().size(), discs.size()))
            .withTargets(this::started);
  }

  Scenario drawn() {
    return drawn;
  }

  /** A number from -most to most. */
  private double within(double most) {
    return most * (2 * random.nextDouble() - 1);
  }

  /** A number on the same side of 0. */
  private double beside(double old, double least, double most) {
    return Math.copySign(random.nextDouble(least, most), old);
  }

  private CameraSpec mounted(CameraSpec camera) {
    double x = beside(camera.x(), 500, CORNER);
    double y = beside(camera.y(), 500, CORNER);
    discs.add(new Obstacle.Pillar(x, y, CAMERA_RADIUS, 1));
    OpticsSpec optics =
        camera
            .optics()
            .orElseThrow()
            .with(
                OpticsSpec.ANGLES_OF_VIEW,
                IntStream.rangeClosed(0, (int) ((WIDEST - NARROWEST) / LEVEL))
                    .mapToObj(level -> NARROWEST + level * LEVEL)
                    .toList())
            .with(OpticsSpec.PANS, List.of(0.0))
            .with(OpticsSpec.ZOOM_TIME, 0.0)
            .without(OpticsSpec.PAN_SPEED);
    return camera.with(CameraSpec.X, x).with(CameraSpec.Y, y).with(CameraSpec.OPTICS, optics);
  }

  private Obstacle free(Obstacle.Pillar old) {
    boolean middle = Math.max(Math.abs(old.x()), Math.abs(old.y())) < MIDDLE;
    while (true) {
      double radius = random.nextDouble(25, 100);
      double x = place(old.x(), old.y(), radius, middle);
      double y = place(old.y(), old.x(), radius, middle);
      if (isFree(x, y, radius + GAP)) {
        return new Obstacle.Pillar(x, y, radius, old.transmittance());
      }
    }
  }

  /** At an edge targets can pass on both sides: a fifth of the radius is free there. */
  private double place(double old, double other, double radius, boolean middle) {
    return Math.abs(old) == EDGE
        ? Math.copySign(Math.min(EDGE, BORDER - 1.2 * radius), old)
        : Math.abs(other) == EDGE
            ? within(500)
            : middle ? within(MIDDLE) : beside(old, MIDDLE, CORNER);
  }

  private boolean isFree(double x, double y, double away) {
    return discs.stream().allMatch(disc -> off(disc, x, y) >= away);
  }

  /** How far a place is off the border of a disc, less than 0 inside. */
  static double off(Obstacle disc, double x, double y) {
    Obstacle.Pillar pillar = (Obstacle.Pillar) disc;
    return Math.hypot(x - pillar.x(), y - pillar.y()) - pillar.radius();
  }

  private TargetSpec started(TargetSpec target) {
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
        .with(TargetSpec.SPEED, started++ % 2 == 0 ? FAST : SLOW);
  }

  /** Puts a target where it comes to from a step: it slides along what is in its way. */
  void step(int target, Targets targets, double dx, double dy) {
    double x = targets.x(target) + dx;
    double y = targets.y(target) + dy;
    for (Obstacle disc : discs) {
      double off = off(disc, x, y);
      if (off < 0) {
        Obstacle.Pillar pillar = (Obstacle.Pillar) disc;
        double out = off / (pillar.radius() + off);
        x -= out * (x - pillar.x());
        y -= out * (y - pillar.y());
      }
    }
    targets.put(target, GreedyCameras.within(x, BORDER), GreedyCameras.within(y, BORDER));
  }
}
