package org.hificamsim.bench;

import java.util.SplittableRandom;
import org.hificamsim.solver.configuration.CoverageProblem;

/**
 * One step of a random field, as a coverage problem. It is a hard one, since no level is better in
 * every way than another: at each, a camera detects from 0.4 of the level's radius to the radius,
 * so that it loses what is near when it zooms out.
 *
 * @param sets for each camera and level, the targets that are detected, as bits
 */
record OptimumInstance(int targets, long[][] sets) {
  private static final double[] RADII = {2.5, 3.75, 5, 6.25, 7.5};
  private static final double NEAREST = 0.4;
  private static final double RATIO = 1.5;

  /** The number of cameras. */
  static final int CAMERAS = 200;

  private static final int TARGETS = 40;

  /** The density of cameras, as square metres per camera. */
  enum Density {
    /**
     * The density of the cluster scenarios, where a target is within reach of 4 cameras on average.
     */
    CLUSTER(30.0 * 20 / 14),
    /** Four times the density of the cluster scenarios. */
    FOURFOLD(30.0 * 20 / 14 / 4),
    /** All 200 cameras on the field of the cluster scenarios: about 43 cameras reach a target. */
    CROWD(30.0 * 20 / CAMERAS);

    private final double area;

    Density(double area) {
      this.area = area;
    }
  }

  /** Returns the instance of a seed. */
  static OptimumInstance random(Density density, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    double height = Math.sqrt(CAMERAS * density.area / RATIO);
    double[][] cameras = places(CAMERAS, height, random);
    double[][] targets = places(TARGETS, height, random);
    long[][] sets = new long[CAMERAS][RADII.length];
    for (int camera = 0; camera < CAMERAS; camera++) {
      for (int target = 0; target < TARGETS; target++) {
        double distance =
            Math.hypot(
                targets[target][0] - cameras[camera][0], targets[target][1] - cameras[camera][1]);
        for (int level = 0; level < RADII.length; level++) {
          boolean seen = distance >= NEAREST * RADII[level] && distance <= RADII[level];
          sets[camera][level] |= seen ? 1L << target : 0;
        }
      }
    }
    return new OptimumInstance(TARGETS, sets);
  }

  private static double[][] places(int count, double height, SplittableRandom random) {
    double[][] places = new double[count][];
    for (int i = 0; i < count; i++) {
      places[i] = new double[] {random.nextDouble(RATIO * height), random.nextDouble(height)};
    }
    return places;
  }

  /** Returns a problem with room for any instance. */
  static CoverageProblem emptyProblem() {
    return new CoverageProblem(CAMERAS, CAMERAS * RADII.length, TARGETS);
  }

  /** Fills a problem with the instance. */
  void fill(CoverageProblem problem) {
    problem.clear(targets);
    for (long[] camera : sets) {
      problem.addCamera();
      for (int level = 0; level < camera.length; level++) {
        problem.addSet(camera, level);
      }
    }
  }

  /** Returns the targets of each set, by camera, as JSON on one line. */
  String json() {
    StringBuilder json =
        new StringBuilder("{\"targets\":").append(targets).append(",\"cameras\":[");
    for (int camera = 0; camera < sets.length; camera++) {
      json.append(camera == 0 ? "[" : ",[");
      for (int level = 0; level < sets[camera].length; level++) {
        json.append(level == 0 ? "[" : ",[");
        String separator = "";
        for (long bits = sets[camera][level]; bits != 0; bits &= bits - 1) {
          json.append(separator).append(Long.numberOfTrailingZeros(bits));
          separator = ",";
        }
        json.append(']');
      }
      json.append(']');
    }
    return json.append("]}").toString();
  }
}
