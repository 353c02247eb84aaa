package org.hificamsim.presentation.view;

import java.nio.file.Path;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.movement.Movements;

/** The scenarios of the project. */
final class Scenarios {
  private Scenarios() {}

  static Scenario read(String name) {
    Path folder = Path.of(System.getProperty("hificamsim.root", "."), "scenarios");
    return ScenarioReader.read(
        folder.resolve(name + ".xml"), Movements.registry()::knows, warning -> {});
  }
}
