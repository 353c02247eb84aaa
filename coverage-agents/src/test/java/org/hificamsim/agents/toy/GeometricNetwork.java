package org.hificamsim.agents.toy;

import java.util.SplittableRandom;

/**
 * A toy world in the plane: each camera detects, at each view, the targets of each size within a
 * ring of distances and inside its angle of view. Targets jump to new places on request.
 */
public final class GeometricNetwork extends ToyNetwork {
  /** The parameters of random worlds. */
  public record Kind(
      int cameras,
      int views,
      int targets,
      int sizes,
      boolean nested,
      boolean sectors,
      double field,
      double reach) {}

  private final Kind kind;
  private final SplittableRandom random;
  private final double[][] camera;
  private final double[][][][] ring;
  private final double[][] target;
  private final int[] size;

  private GeometricNetwork(Kind kind, int[] views, SplittableRandom random) {
    super(kind.targets, views);
    this.kind = kind;
    this.random = random;
    camera = new double[kind.cameras][];
    ring = new double[kind.cameras][][][];
    for (int c = 0; c < kind.cameras; c++) {
      double angle = kind.sectors ? 0.5 + random.nextDouble(2 * Math.PI) : 2 * Math.PI;
      camera[c] = new double[] {anywhere(), anywhere(), random.nextDouble(2 * Math.PI), angle};
      ring[c] = new double[views[c]][kind.sizes][];
      for (int view = 0; view < views[c]; view++) {
        double outer = kind.reach * (view + 1) / views[c];
        for (int s = 0; s < kind.sizes; s++) {
          double inner = kind.nested ? 0 : random.nextDouble(outer);
          ring[c][view][s] = new double[] {inner, inner + random.nextDouble(outer - inner)};
        }
      }
    }
    target = new double[kind.targets][];
    size = new int[kind.targets];
    for (int t = 0; t < kind.targets; t++) {
      size[t] = random.nextInt(kind.sizes);
    }
    scatter();
  }

  /** Returns a random world, which is the same for the same kind and seed. */
  public static GeometricNetwork random(Kind kind, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] views = new int[kind.cameras];
    for (int c = 0; c < kind.cameras; c++) {
      views[c] = kind.views < 0 ? 1 + random.nextInt(-kind.views) : kind.views;
    }
    return new GeometricNetwork(kind, views, random);
  }

  /** Lets cameras turn, and moves take time: as {@link #turning} and {@link #moving}. */
  public GeometricNetwork turned(int pans, int steps) {
    turning(pans).slow(steps);
    scatter();
    return this;
  }

  /** Moves every target to a random position. */
  public void scatter() {
    for (int t = 0; t < targets(); t++) {
      target[t] = new double[] {anywhere(), anywhere()};
    }
    for (int c = 0; c < cameras(); c++) {
      for (int view = 0; view < views(c); view++) {
        for (int t = 0; t < targets(); t++) {
          see(c, view, t, sees(c, view, t));
        }
      }
    }
  }

  /** Switches cameras and targets at random. */
  public void disturb() {
    for (int c = 0; c < cameras(); c++) {
      if (random.nextInt(4) == 0) {
        switchCamera(c, !online(c));
      }
    }
    for (int t = 0; t < targets(); t++) {
      if (random.nextInt(4) == 0) {
        showTarget(t, !present(t));
      }
    }
  }

  private double anywhere() {
    return random.nextDouble(kind.field);
  }

  private boolean sees(int c, int view, int t) {
    double dx = target[t][0] - camera[c][0];
    double dy = target[t][1] - camera[c][1];
    double distance = Math.hypot(dx, dy);
    double turn =
        Math.abs(Math.IEEEremainder(Math.atan2(dx, dy) - camera[c][2] - pan(c, view), 2 * Math.PI));
    double[] within = ring[c][view][size[t]];
    return turn <= camera[c][3] / 2 && distance >= within[0] && distance <= within[1];
  }

  @Override
  public double cameraX(int c) {
    return camera[c][0];
  }

  @Override
  public double cameraY(int c) {
    return camera[c][1];
  }

  @Override
  public double cameraHeading(int c) {
    return camera[c][2];
  }

  @Override
  protected double x(int t) {
    return target[t][0];
  }

  @Override
  protected double y(int t) {
    return target[t][1];
  }

  @Override
  protected boolean provenSuperset(int c, int view, int other) {
    for (int s = 0; s < kind.sizes; s++) {
      double[] outer = ring[c][view][s];
      double[] inner = ring[c][other][s];
      if (outer[0] > inner[0] || outer[1] < inner[1]) {
        return false;
      }
    }
    return true;
  }
}
