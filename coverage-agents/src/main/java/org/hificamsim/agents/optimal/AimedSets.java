package org.hificamsim.agents.optimal;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.core.policy.NetworkView;

/**
 * The maximal detection sets of cameras that may pan to any angle between their outermost ones, as
 * a coverage problem: for each zoom level those of {@link PanSweep}, from the narrowest level.
 */
final class AimedSets implements ConfigurationSets {
  private final CoverageProblem problem;
  private final PanSweep sweep;
  private final int[] viewOf;
  private final double[] panOf;
  private final int[] places;
  private final int[] who;
  private final double[] bearings;
  private final long[] mask;
  private final double[] from; // pan angles, by camera, before any is aimed
  private final double[] to;

  AimedSets(NetworkView network) {
    int targets = network.targets();
    int sets =
        IntStream.range(0, network.cameras())
            .map(camera -> 1 + network.zooms(camera) * (targets + 2))
            .sum();
    problem = new CoverageProblem(network.cameras(), sets, targets);
    sweep = new PanSweep(targets);
    viewOf = new int[sets];
    panOf = new double[sets];
    places = new int[targets];
    who = new int[targets];
    bearings = new double[targets];
    mask = new long[CoverageProblem.wordsFor(targets)];
    from = IntStream.range(0, network.cameras()).mapToDouble(c -> network.pan(c, 0)).toArray();
    to =
        IntStream.range(0, network.cameras())
            .mapToDouble(c -> network.pan(c, network.views(c) - 1))
            .toArray();
  }

  /** The problem that {@link #fill} fills. */
  CoverageProblem problem() {
    return problem;
  }

  @Override
  public int viewOf(int set) {
    return viewOf[set];
  }

  /** The pan angle of a set, radians off the camera's heading; NaN for the view's own. */
  double panOf(int set) {
    return panOf[set];
  }

  @Override
  public boolean fill(NetworkView network) {
    int present = 0;
    for (int target = 0; target < network.targets(); target++) {
      places[target] = network.present(target) ? present++ : -1;
    }
    if (present == 0) {
      return false;
    }
    problem.clear(present);
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        problem.addCamera();
        addAll(network, camera);
      }
    }
    return true;
  }

  private void addAll(NetworkView network, int camera) {
    int first = problem.sets();
    for (int zoom = 0; zoom < network.zooms(camera); zoom++) {
      int near = findTargets(network, camera, zoom);
      double opening = network.zoom(camera, zoom).viewingAngle();
      sweep.sweep(bearings, near, opening, from[camera], to[camera]);
      for (int i = 0; i < sweep.count(); i++) {
        add(i, near, zoom);
      }
    }
    if (problem.sets() == first) {
      Arrays.fill(mask, 0);
      put(network.view(camera), Double.NaN);
    }
  }

  /** Lists the targets that the camera could detect at a zoom level, with their bearings. */
  private int findTargets(NetworkView network, int camera, int zoom) {
    int near = 0;
    for (int target = 0; target < places.length; target++) {
      if (places[target] >= 0 && network.oracle().detectsTurned(camera, zoom, target)) {
        double dx = network.oracle().targetX(target) - network.cameraX(camera);
        double dy = network.oracle().targetY(target) - network.cameraY(camera);
        bearings[near] = Math.atan2(dx, dy) - network.cameraHeading(camera);
        who[near++] = places[target];
      }
    }
    return near;
  }

  private void add(int swept, int near, int zoom) {
    Arrays.fill(mask, 0);
    for (int i = 0; i < near; i++) {
      if ((sweep.mask(swept, i >> 6) >>> i & 1) != 0) {
        mask[who[i] >> 6] |= 1L << who[i];
      }
    }
    if (!problem.lastCameraHas(mask, 0)) {
      put(zoom, sweep.pan(swept));
    }
  }

  private void put(int view, double pan) {
    viewOf[problem.sets()] = view;
    panOf[problem.sets()] = pan;
    problem.addSet(mask, 0);
  }
}
