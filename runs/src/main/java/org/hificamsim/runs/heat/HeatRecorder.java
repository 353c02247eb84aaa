package org.hificamsim.runs.heat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * Makes a heat map of the steps it is told of, in one run after the other. What cameras see of the
 * cells is found once for each view; steps in which all cameras see as in the one before cost next
 * to nothing.
 */
public final class HeatRecorder implements StepListener {
  private static final int NO_VIEW = -1;

  private final FieldCells cells;
  private final Obstacles obstacles;
  private final ViewCells views;
  private final Covering covering;
  private final Visits visits;
  private SeenCells[] seen = {};
  private SeenCells[] before = {};
  private long alike;
  private int revision;

  /**
   * @param world of the first run, for what does not change
   * @param most cells along the field's longer side
   */
  public HeatRecorder(World world, Detection detection, int most) {
    this.cells = FieldCells.of(world.scenario().field(), most);
    this.obstacles = new Obstacles(world.scenario().obstacles());
    this.views = new ViewCells(cells, detection, obstacles, Reach.usualTarget(world));
    this.covering = new Covering(cells.count());
    this.visits = new Visits(cells);
  }

  @Override
  public void started(NetworkView network) {
    seen = new SeenCells[network.cameras()];
    before = new SeenCells[network.cameras()];
    revision = network.revision();
    views.forget(network);
  }

  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    if (revision != network.revision() || seen.length != network.cameras()) {
      addAlike();
      started(network);
    }
    for (int camera = 0; camera < seen.length; camera++) {
      boolean online = network.online(camera);
      seen[camera] = views.of(network, camera, online ? network.seeing(camera) : NO_VIEW);
    }
    if (!Arrays.equals(seen, before)) {
      addAlike();
      System.arraycopy(seen, 0, before, 0, seen.length);
    }
    alike++;
    visits.add(network);
  }

  @Override
  public void ended(NetworkView network) {
    addAlike();
  }

  private void addAlike() {
    if (alike > 0) {
      covering.add(before, alike);
      alike = 0;
    }
  }

  /** How many steps it has been told of. */
  public long steps() {
    return covering.steps() + alike;
  }

  /** The map of the steps so far; one at least. */
  public HeatMap map() {
    addAlike();
    List<Place> places = IntStream.range(0, cells.count()).mapToObj(this::place).toList();
    return new HeatMap(cells, places);
  }

  private Place place(int cell) {
    boolean free = obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty();
    double none = covering.covered0(cell);
    double one = covering.covered1(cell);
    return new Place(
        free ? covering.meanK(cell) : Double.NaN,
        free ? none : Double.NaN,
        free ? one : Double.NaN,
        free ? Math.max(0, 1 - none - one) : Double.NaN,
        visits.count(cell),
        visits.meanK(cell),
        visits.covered0(cell));
  }
}
