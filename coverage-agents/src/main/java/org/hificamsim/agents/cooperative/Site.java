package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.solver.way.TravelTimes;

/**
 * The cameras' knowledge of the site: its cells, and what each camera can see according to the map.
 * Sight is exact for the obstacles on the map, which may differ from the real ones.
 */
final class Site {
  /** The size of the targets that cells are searched for, about that of a person, in metres. */
  private static final double SEARCHED_SIZE = 1;

  private final Obstacles map;
  private final VisibleRegion[] visibleRegions;
  private final Grid grid;
  private final boolean[] free;
  private final CellSight cellSight;
  private final TravelTimes[] travelTimes;
  private int revision = -1;

  Site(NetworkView network, Obstacles map, int cells) {
    this.map = map;
    visibleRegions = new VisibleRegion[network.cameras()];
    grid = Grid.over(network.field(), cells);
    free = new boolean[grid.cells()];
    for (int cell = 0; cell < free.length; cell++) {
      free[cell] = map.containing(grid.x(cell, 0.5), grid.y(cell, 0.5)).isEmpty();
    }
    cellSight = new CellSight(grid, network.cameras());
    travelTimes = new TravelTimes[network.cameras()];
    Arrays.setAll(travelTimes, camera -> TravelTimes.of(network, camera));
  }

  /**
   * Updates the site if a camera stands elsewhere than before. A camera that was only turned, or
   * given other views, keeps its old cells until any camera moves.
   */
  void refresh(NetworkView network) {
    if (revision == network.revision()) {
      return;
    }
    revision = network.revision();
    boolean anyMoved = false;
    for (int camera = 0; camera < visibleRegions.length; camera++) {
      if (!travelTimes[camera].matches(network, camera)) {
        travelTimes[camera] = TravelTimes.of(network, camera);
      }
      double x = network.cameraX(camera);
      double y = network.cameraY(camera);
      if (visibleRegions[camera] == null || !visibleRegions[camera].isFrom(x, y)) {
        visibleRegions[camera] = VisibleRegion.of(map, x, y);
        anyMoved = true;
      }
    }
    if (anyMoved) {
      cellSight.update(network, this, SEARCHED_SIZE);
    }
  }

  /** Computes {@link NetworkView#chancesAt} with the transmittance of the obstacles on the map. */
  boolean chances(
      NetworkView network, int camera, double x, double y, double size, double[] chances) {
    double z = network.zoom(camera, 0).vertical().z();
    Body body = network.body(size);
    double transmittance = visibleRegions[camera].transmittance(x, y, z, body.low(), body.high());
    return transmittance > 0 && network.chancesAt(camera, x, y, size, transmittance, chances);
  }

  /** The obstacles that the cameras know. */
  Obstacles map() {
    return map;
  }

  Grid grid() {
    return grid;
  }

  /** Returns whether a target can be in each cell. */
  boolean[] free() {
    return free;
  }

  /** Returns how many steps a camera's moves between its views take. */
  TravelTimes travelTimes(int camera) {
    return travelTimes[camera];
  }

  /** The cells that cameras see. */
  CellSight cellSight() {
    return cellSight;
  }
}
