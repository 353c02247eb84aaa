package org.hificamsim.agents.cooperative;

import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Body;

/**
 * What all cameras know of the site: its cells, and what is seen from where by the map that they
 * have of it: exact sight, past the obstacles that are on the map, whatever is there.
 */
final class Site {
  /** Cells are searched for targets of this size, about that of a person, metres. */
  private static final double SEARCHED = 1;

  private final Obstacles map;
  private final VisibleRegion[] regions; // by camera
  private final Grid grid;
  private final boolean[] free;
  private final CellSight cells;
  private int revision = -1;

  Site(NetworkView network, Obstacles map, int cells) {
    this.map = map;
    regions = new VisibleRegion[network.cameras()];
    grid = Grid.over(network.field(), cells);
    free = new boolean[grid.cells()];
    for (int cell = 0; cell < free.length; cell++) {
      free[cell] = map.containing(grid.x(cell, 0.5), grid.y(cell, 0.5)).isEmpty();
    }
    this.cells = new CellSight(grid, network.cameras());
  }

  /** Takes note of cameras that were added, moved or refitted. */
  void refresh(NetworkView network) {
    if (revision == network.revision()) {
      return;
    }
    revision = network.revision();
    boolean moved = false;
    for (int camera = 0; camera < regions.length; camera++) {
      double x = network.cameraX(camera);
      double y = network.cameraY(camera);
      if (regions[camera] == null || !regions[camera].isFrom(x, y)) {
        regions[camera] = VisibleRegion.of(map, x, y);
        moved = true;
      }
    }
    if (moved) {
      cells.find(network, this, SEARCHED);
    }
  }

  /** As {@link NetworkView#chancesAt}, past the obstacles of the map. */
  boolean chances(
      NetworkView network, int camera, double x, double y, double size, double[] chances) {
    double z = network.zoom(camera, 0).vertical().z();
    Body body = network.body(size);
    double through = regions[camera].transmittance(x, y, z, body.low(), body.high());
    return through > 0 && network.chancesAt(camera, x, y, size, through, chances);
  }

  /** The obstacles that cameras know of. */
  Obstacles map() {
    return map;
  }

  Grid grid() {
    return grid;
  }

  /** Which cells a target can be in. */
  boolean[] free() {
    return free;
  }

  /** What is seen of cells. */
  CellSight cells() {
    return cells;
  }
}
