package org.hificamsim.runs.heat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.ViewCells;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * Makes a heat map of the steps that it receives, in one run after the other. What cameras see of
 * the cells is found once for each view; steps in which all cameras see as in the one before cost
 * next to nothing. Detections are independent, so the chances of no and of one camera follow from
 * those of each.
 */
public final class HeatRecorder implements StepListener {
  private final FieldCells cells;
  private final Obstacles obstacles;
  private final ViewCells views;
  private final double[] none; // of the steps that are being added, as is one
  private final double[] one;
  private final double[] covered0;
  private final double[] covered1;
  private final double[] k;
  private final long[] visits;
  private final long[] detections;
  private final long[] uncovered;
  private ViewCells.Seen[] seen = {};
  private long alike;
  private long added; // steps

  /**
   * @param world of the first run, for what does not change
   * @param most cells along the field's longer side
   */
  public HeatRecorder(World world, Detection detection, int most) {
    this.cells = FieldCells.of(world.scenario().field(), most);
    this.obstacles = new Obstacles(world.scenario().obstacles());
    this.views = new ViewCells(cells, detection, obstacles, Reach.usualTarget(world));
    none = new double[cells.count()];
    one = new double[cells.count()];
    covered0 = new double[cells.count()];
    covered1 = new double[cells.count()];
    k = new double[cells.count()];
    visits = new long[cells.count()];
    detections = new long[cells.count()];
    uncovered = new long[cells.count()];
  }

  @Override
  public void started(OracleView network) {
    views.forget(network);
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    ViewCells.Seen[] now = views.now(network);
    if (now != seen) {
      addAlike();
      seen = now;
    }
    alike++;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        addVisit(
            cells.at(network.targetX(target), network.targetY(target)), network.coverage(target));
      }
    }
  }

  private void addVisit(int cell, int cameras) {
    if (cell >= 0) {
      visits[cell]++;
      detections[cell] += cameras;
      uncovered[cell] += cameras == 0 ? 1 : 0;
    }
  }

  @Override
  public void ended(OracleView network) {
    addAlike();
  }

  /** Adds the steps that were alike; none are left then. */
  private void addAlike() {
    Arrays.fill(none, 1);
    Arrays.fill(one, 0);
    for (ViewCells.Seen camera : seen) {
      add(camera);
    }
    for (int cell = 0; cell < none.length; cell++) {
      covered0[cell] += alike * none[cell];
      covered1[cell] += alike * one[cell];
    }
    added += alike;
    alike = 0;
  }

  private void add(ViewCells.Seen camera) {
    for (int i = 0; i < camera.cells().length; i++) {
      int cell = camera.cells()[i];
      double chance = camera.chances()[i];
      k[cell] += alike * chance;
      one[cell] = one[cell] * (1 - chance) + none[cell] * chance;
      none[cell] *= 1 - chance;
    }
  }

  /** How many steps it has received. */
  public long steps() {
    return added + alike;
  }

  /** The map of the steps so far; one at least. */
  public HeatMap map() {
    addAlike();
    List<Place> places = IntStream.range(0, cells.count()).mapToObj(this::place).toList();
    return new HeatMap(cells, places);
  }

  /** Nothing is seen where an obstacle is in the middle of the cell. */
  private Place place(int cell) {
    boolean free = obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty();
    double steps0 = covered0[cell] / added;
    double steps1 = covered1[cell] / added;
    return new Place(
        free ? k[cell] / added : Double.NaN,
        free ? steps0 : Double.NaN,
        free ? steps1 : Double.NaN,
        free ? Math.max(0, 1 - steps0 - steps1) : Double.NaN,
        visits[cell],
        (double) detections[cell] / visits[cell],
        (double) uncovered[cell] / visits[cell]);
  }
}
