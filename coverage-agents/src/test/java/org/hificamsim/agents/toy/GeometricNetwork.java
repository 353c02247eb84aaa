package org.hificamsim.agents.toy;

import java.util.SplittableRandom;

/**
 * A toy world in the plane. In each view a camera detects the targets of each size that are within
 * a ring of distances and inside its angle of view. Targets jump to new positions on request.
 */
public final class GeometricNetwork extends ToyNetwork {
  /**
   * The parameters of random worlds.
   *
   * @param views number of views of each camera; if negative, a random number up to its absolute
   *     value
   * @param sizes number of different sizes of targets
   * @param nested whether rings begin at distance 0, so that wider views include narrower ones
   * @param sectors whether cameras have an angle of view, and do not look all round
   * @param field side of the square in which cameras and targets are
   * @param reach greatest distance of any ring
   */
  public record Kind(
      int cameras,
      int views,
      int targets,
      int sizes,
      boolean nested,
      boolean sectors,
      double field,
      double reach) {}

  private record PlacedCamera(double x, double y, double heading, double angle) {}

  private record Ring(double inner, double outer) {}

  private record Position(double x, double y) {}

  private final Kind kind;
  private final SplittableRandom random;
  private final PlacedCamera[] placedCameras;

  /** The distances at which a camera detects a target, by camera, view and size of the target. */
  private final Ring[][][] rings;

  private final Position[] positions;
  private final int[] sizes;

  private GeometricNetwork(Kind kind, int[] views, SplittableRandom random) {
    super(kind.targets, views);
    this.kind = kind;
    this.random = random;
    placedCameras = new PlacedCamera[kind.cameras];
    rings = new Ring[kind.cameras][][];
    for (int camera = 0; camera < kind.cameras; camera++) {
      double angle = kind.sectors ? 0.5 + random.nextDouble(2 * Math.PI) : 2 * Math.PI;
      placedCameras[camera] =
          new PlacedCamera(
              randomCoordinate(), randomCoordinate(), random.nextDouble(2 * Math.PI), angle);
      rings[camera] = new Ring[views[camera]][kind.sizes];
      for (int view = 0; view < views[camera]; view++) {
        double limit = kind.reach * (view + 1) / views[camera];
        for (int size = 0; size < kind.sizes; size++) {
          double inner = kind.nested ? 0 : random.nextDouble(limit);
          rings[camera][view][size] = new Ring(inner, inner + random.nextDouble(limit - inner));
        }
      }
    }
    positions = new Position[kind.targets];
    sizes = new int[kind.targets];
    for (int target = 0; target < kind.targets; target++) {
      sizes[target] = random.nextInt(kind.sizes);
    }
    scatter();
  }

  /** Returns a random world, which is the same for the same kind and seed. */
  public static GeometricNetwork random(Kind kind, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] views = new int[kind.cameras];
    for (int camera = 0; camera < kind.cameras; camera++) {
      views[camera] = kind.views < 0 ? 1 + random.nextInt(-kind.views) : kind.views;
    }
    return new GeometricNetwork(kind, views, random);
  }

  /** Lets cameras turn ({@link #turning}), and moves take additional steps ({@link #slow}). */
  public GeometricNetwork turned(int pans, int steps) {
    turning(pans).slow(steps);
    scatter();
    return this;
  }

  /** Moves every target to a random position. */
  public void scatter() {
    for (int target = 0; target < targets(); target++) {
      positions[target] = new Position(randomCoordinate(), randomCoordinate());
    }
    for (int camera = 0; camera < cameras(); camera++) {
      for (int view = 0; view < views(camera); view++) {
        for (int target = 0; target < targets(); target++) {
          see(camera, view, target, sees(camera, view, target));
        }
      }
    }
  }

  /** Switches cameras and targets at random. */
  public void disturb() {
    for (int camera = 0; camera < cameras(); camera++) {
      if (random.nextInt(4) == 0) {
        switchCamera(camera, !online(camera));
      }
    }
    for (int target = 0; target < targets(); target++) {
      if (random.nextInt(4) == 0) {
        showTarget(target, !present(target));
      }
    }
  }

  private double randomCoordinate() {
    return random.nextDouble(kind.field);
  }

  private boolean sees(int camera, int view, int target) {
    PlacedCamera placed = placedCameras[camera];
    double dx = positions[target].x - placed.x;
    double dy = positions[target].y - placed.y;
    double distance = Math.hypot(dx, dy);
    double bearing = Math.atan2(dx, dy) - placed.heading - pan(camera, view);
    double offAxis = Math.abs(Math.IEEEremainder(bearing, 2 * Math.PI));
    Ring ring = rings[camera][view][sizes[target]];
    return offAxis <= placed.angle / 2 && distance >= ring.inner && distance <= ring.outer;
  }

  @Override
  public double cameraX(int camera) {
    return placedCameras[camera].x;
  }

  @Override
  public double cameraY(int camera) {
    return placedCameras[camera].y;
  }

  @Override
  public double cameraHeading(int camera) {
    return placedCameras[camera].heading;
  }

  @Override
  protected double x(int target) {
    return positions[target].x;
  }

  @Override
  protected double y(int target) {
    return positions[target].y;
  }

  @Override
  protected boolean provenSuperset(int camera, int view, int other) {
    for (int size = 0; size < kind.sizes; size++) {
      Ring ring = rings[camera][view][size];
      Ring otherRing = rings[camera][other][size];
      if (ring.inner > otherRing.inner || ring.outer < otherRing.outer) {
        return false;
      }
    }
    return true;
  }
}
