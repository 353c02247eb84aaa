package org.hificamsim.runs.heat;

import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.ViewCells;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * Makes a heat map of the steps that it receives, in one run after the other. What cameras see of
 * the cells is found once for each view; steps in which all cameras see as in the one before cost
 * next to nothing.
 */
public final class HeatRecorder implements StepListener {
  private final FieldCells cells;
  private final Obstacles obstacles;
  private final ViewCells views;
  private final CellSums sums;
  private ViewCells.Seen[] seen = {};
  private long alike;

  /**
   * @param world of the first run, for what does not change
   * @param most cells along the field's longer side
   */
  public HeatRecorder(World world, Detection detection, int most) {
    this.cells = FieldCells.of(world.scenario().field(), most);
    this.obstacles = new Obstacles(world.scenario().obstacles());
    this.views = new ViewCells(cells, detection, obstacles, Reach.usualTarget(world));
    this.sums = new CellSums(cells);
  }

  @Override
  public void started(NetworkView network) {
    views.forget(network);
  }

  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    ViewCells.Seen[] now = views.now(network);
    if (now != seen) {
      addAlike();
      seen = now;
    }
    alike++;
    sums.addVisits(network);
  }

  @Override
  public void ended(NetworkView network) {
    addAlike();
  }

  private void addAlike() {
    if (alike > 0) {
      sums.add(seen, alike);
      alike = 0;
    }
  }

  /** How many steps it has received. */
  public long steps() {
    return sums.steps() + alike;
  }

  /** The map of the steps so far; one at least. */
  public HeatMap map() {
    addAlike();
    List<Place> places = IntStream.range(0, cells.count()).mapToObj(this::place).toList();
    return new HeatMap(cells, places);
  }

  private Place place(int cell) {
    return sums.place(cell, obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty());
  }
}
