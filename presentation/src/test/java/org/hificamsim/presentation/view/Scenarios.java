package org.hificamsim.presentation.view;

import java.nio.file.Path;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.movement.Movements;

/** Reads scenarios of the project. */
final class Scenarios {
  private Scenarios() {}

  static Scenario read(String name) {
    return from("scenarios/" + name + ".xml");
  }

  /** Reads a scenario with optics, pans that take time, walls, a polygon and pillars. */
  static Scenario hall() {
    return from("src/test/resources/seen/hall.xml");
  }

  private static Scenario from(String file) {
    Path root = Path.of(System.getProperty("hificamsim.root", "."));
    return ScenarioReader.read(root.resolve(file), Movements.registry()::knows, warning -> {});
  }
}
