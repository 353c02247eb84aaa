package org.hificamsim.placement.site;

import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.cells.FieldCells;

/**
 * Counts how often targets are in each cell during a run, recorded or simulated, so that a plan can
 * cover the places where people go.
 */
public final class Visits {
  /** The number of steps if the scenario does not give one. */
  private static final int DEFAULT_STEPS = 1000;

  private Visits() {}

  /** Returns for each cell the number of targets in it, summed over the scenario's steps. */
  public static double[] of(Scenario site, FieldCells cells, Catalogue catalogue) {
    double[] visits = new double[cells.count()];
    World world = new World(site, catalogue.movements(), 0);
    int steps = site.find(Scenario.STEPS).orElse(DEFAULT_STEPS);
    for (int step = 0; step < steps; step++) {
      world.fireEvents(step);
      for (int target = 0; target < world.targets().count(); target++) {
        boolean present = world.targets().present(target);
        int cell =
            present ? cells.cellAt(world.targets().x(target), world.targets().y(target)) : -1;
        if (cell >= 0) {
          visits[cell]++;
        }
      }
      world.moveTargets();
    }
    return visits;
  }
}
