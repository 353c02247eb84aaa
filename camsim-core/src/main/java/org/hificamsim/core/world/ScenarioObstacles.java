package org.hificamsim.core.world;

import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;

/**
 * The obstacles of a scenario, computed once for any number of worlds.
 *
 * @param all those that stand in the field
 * @param map those that cameras believe in
 * @param glass those of all that let a part of the light through
 */
record ScenarioObstacles(Obstacles all, Obstacles map, Obstacles glass) {
  static ScenarioObstacles of(Scenario scenario) {
    Obstacles all = new Obstacles(scenario.obstacles());
    return new ScenarioObstacles(
        all,
        scenario.find(Scenario.MAP).map(Obstacles::new).orElse(all),
        new Obstacles(all.all().stream().filter(obstacle -> !obstacle.solid()).toList()));
  }
}
