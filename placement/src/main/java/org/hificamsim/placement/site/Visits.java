package org.hificamsim.placement.site;

import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.cells.FieldCells;

/** Where targets are over a run, recorded or simulated: demand is where people were. */
public final class Visits {
  private static final int STEPS = 1000; // where the scenario says nothing

  private Visits() {}

  /** By cell: targets in it, summed over the scenario's steps. */
  public static double[] of(Scenario site, FieldCells cells, Catalogue catalogue) {
    double[] visits = new double[cells.count()];
    World world = new World(site, catalogue.movements(), 0);
    int steps = site.find(Scenario.STEPS).orElse(STEPS);
    for (int step = 0; step < steps; step++) {
      world.fireEvents(step);
      for (int target = 0; target < world.targets().count(); target++) {
        boolean present = world.targets().present(target);
        int cell = present ? cells.at(world.targets().x(target), world.targets().y(target)) : -1;
        if (cell >= 0) {
          visits[cell]++;
        }
      }
      world.moveTargets();
    }
    return visits;
  }
}
