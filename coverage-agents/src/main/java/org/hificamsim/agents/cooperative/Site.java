package org.hificamsim.agents.cooperative;

import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;

/** What all cameras know of the site: its cells, and what is seen from where by the map. */
final class Site {
  /** Cells are searched for targets of this size, about that of a person, metres. */
  private static final double SEARCHED = 1;

  private final Grid grid;
  private final boolean[] free;
  private final SiteSight sight;
  private final CellSight cells;

  Site(NetworkView network, Obstacles map, int cells) {
    sight = new SiteSight(map, network.cameras());
    grid = Grid.over(network.field(), cells);
    free = new boolean[grid.cells()];
    for (int cell = 0; cell < free.length; cell++) {
      free[cell] = sight.isFree(grid.x(cell, 0.5), grid.y(cell, 0.5));
    }
    this.cells = new CellSight(grid, network.cameras());
  }

  /** Takes note of cameras that were added, moved or refitted. */
  void refresh(NetworkView network) {
    if (sight.refresh(network)) {
      cells.find(network, sight, free, SEARCHED);
    }
  }

  Grid grid() {
    return grid;
  }

  /** Which cells a target can be in. */
  boolean[] free() {
    return free;
  }

  /** What is seen of a place. */
  SiteSight sight() {
    return sight;
  }

  /** What is seen of cells. */
  CellSight cells() {
    return cells;
  }
}
