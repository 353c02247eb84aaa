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
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.UsualTarget;
import org.hificamsim.runs.cells.ViewCells;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * Makes a heat map of the steps that it receives, run by run. The cells that a camera sees are
 * computed once for each view, and steps in which all cameras see the same as in the step before
 * are only counted. Detections are independent, so the probabilities that no camera or one camera
 * detects follow from the chances of each camera.
 */
public final class HeatRecorder implements StepListener {
  private final FieldCells cells;
  private final Obstacles obstacles;
  private final ViewCells views;

  /** The probability that no camera detects, in the steps that are being added, by cell. */
  private final double[] chanceOfNone;

  /**
   * The probability that exactly one camera detects, in the steps that are being added, by cell.
   */
  private final double[] chanceOfOne;

  private final double[] covered0;
  private final double[] covered1;
  private final double[] cameras;
  private final long[] visits;
  private final long[] detectionsOfVisits;
  private final long[] uncoveredVisits;

  /** The cells that each camera saw in the last steps, which are not added yet. */
  private ViewCells.Seen[] seen = {};

  private long equalSteps;
  private long addedSteps;

  /**
   * @param world the world of the first run, which has the field and obstacles of all runs
   * @param along the number of cells along the field's longer side
   */
  public HeatRecorder(World world, Detection detection, int along) {
    this.cells = FieldCells.of(world.scenario().field(), along);
    this.obstacles = new Obstacles(world.scenario().obstacles());
    double size = UsualTarget.size(world, detection.model());
    this.views =
        new ViewCells(
            cells, detection, obstacles, network -> network.body(size), ViewCells.Condition.NONE);
    chanceOfNone = new double[cells.count()];
    chanceOfOne = new double[cells.count()];
    covered0 = new double[cells.count()];
    covered1 = new double[cells.count()];
    cameras = new double[cells.count()];
    visits = new long[cells.count()];
    detectionsOfVisits = new long[cells.count()];
    uncoveredVisits = new long[cells.count()];
  }

  @Override
  public void started(OracleView network) {
    views.forget(network);
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    ViewCells.Seen[] now = views.now(network);
    if (now != seen) {
      addEqualSteps();
      seen = now;
    }
    equalSteps++;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        addVisit(
            cells.cellAt(network.targetX(target), network.targetY(target)),
            network.coverage(target));
      }
    }
  }

  private void addVisit(int cell, int detectingCameras) {
    if (cell >= 0) {
      visits[cell]++;
      detectionsOfVisits[cell] += detectingCameras;
      uncoveredVisits[cell] += detectingCameras == 0 ? 1 : 0;
    }
  }

  @Override
  public void ended(OracleView network) {
    addEqualSteps();
  }

  /** Adds the last steps, in which all cameras saw the same. */
  private void addEqualSteps() {
    Arrays.fill(chanceOfNone, 1);
    Arrays.fill(chanceOfOne, 0);
    for (ViewCells.Seen seenByCamera : seen) {
      add(seenByCamera);
    }
    for (int cell = 0; cell < chanceOfNone.length; cell++) {
      covered0[cell] += equalSteps * chanceOfNone[cell];
      covered1[cell] += equalSteps * chanceOfOne[cell];
    }
    addedSteps += equalSteps;
    equalSteps = 0;
  }

  private void add(ViewCells.Seen seenByCamera) {
    for (int i = 0; i < seenByCamera.cells().length; i++) {
      int cell = seenByCamera.cells()[i];
      double chance = seenByCamera.chances()[i];
      cameras[cell] += equalSteps * chance;
      chanceOfOne[cell] = chanceOfOne[cell] * (1 - chance) + chanceOfNone[cell] * chance;
      chanceOfNone[cell] *= 1 - chance;
    }
  }

  /** The number of steps so far. */
  public long steps() {
    return addedSteps + equalSteps;
  }

  /** Returns the map of the steps so far; there has to be at least one. */
  public HeatMap map() {
    addEqualSteps();
    List<Place> places = IntStream.range(0, cells.count()).mapToObj(this::place).toList();
    return new HeatMap(cells, places);
  }

  /** The coverage of a cell; NaN if an obstacle is in its centre. */
  private Place place(int cell) {
    boolean isFree = obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty();
    double share0 = covered0[cell] / addedSteps;
    double share1 = covered1[cell] / addedSteps;
    return new Place(
        isFree ? cameras[cell] / addedSteps : Double.NaN,
        isFree ? share0 : Double.NaN,
        isFree ? share1 : Double.NaN,
        isFree ? Math.max(0, 1 - share0 - share1) : Double.NaN,
        visits[cell],
        (double) detectionsOfVisits[cell] / visits[cell],
        (double) uncoveredVisits[cell] / visits[cell]);
  }
}
