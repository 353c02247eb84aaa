package org.hificamsim.network.files;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.network.CamSimDialect;
import org.hificamsim.network.NetworkSettings;

/** Reads a scenario file as CamSim would: its order of a step, its ranges, its movements. */
public final class CamSimScenario {
  private CamSimScenario() {}

  /**
   * Reads the file.
   *
   * @param movement of all objects, a class name; null for that of the file
   * @param zooming whether the file's zoom list counts, which CamSim ignores
   * @throws InputException when the file, or what is asked for, is wrong
   */
  public static Scenario read(
      Path file,
      String movement,
      boolean zooming,
      NetworkSettings settings,
      Catalogue catalogue,
      PrintWriter err) {
    Scenario scenario =
        ScenarioReader.read(
                file,
                catalogue.movements().names()::contains,
                warning -> err.println("warning: " + Place.printable(warning)))
            .withOrder(StepOrder.CAMSIM);
    warnAboutDefaults(file, scenario, settings, err);
    if (!zooming) {
      scenario = scenario.withoutZooms();
    }
    if (movement != null) {
      scenario = scenario.withMovement(movement);
      requireWaypoints(scenario, movement);
    }
    return CamSimDialect.read(scenario, settings);
  }

  private static void requireWaypoints(Scenario scenario, String movement) {
    Stream<TargetSpec> added =
        scenario.events().stream()
            .filter(ScenarioEvent.AddTarget.class::isInstance)
            .map(event -> ((ScenarioEvent.AddTarget) event).target());
    Stream.concat(scenario.targets().stream(), added)
        .filter(target -> target.movement().shortName().equals("Waypoints"))
        .filter(target -> target.movement().waypoints().isEmpty())
        .findFirst()
        .ifPresent(
            target -> {
              throw new InputException(
                  "-m '%s': object %s has no waypoints, expected at least two"
                      .formatted(movement, target.name()));
            });
  }

  private static void warnAboutDefaults(
      Path file, Scenario scenario, NetworkSettings settings, PrintWriter err) {
    List<String> missing = new ArrayList<>();
    if (settings.schedule().isEmpty()
        && lacks(scenario, camera -> camera.agent().algorithm().isEmpty())) {
      missing.add("ai_algorithm, taken as Active");
    }
    if (settings.comm().isEmpty() && lacks(scenario, camera -> camera.agent().comm().isEmpty())) {
      missing.add("comm, taken as 0");
    }
    if (!missing.isEmpty()) {
      err.println(
          "warning: %s: cameras without %s".formatted(file, String.join(", and ", missing)));
    }
  }

  private static boolean lacks(
      Scenario scenario, java.util.function.Predicate<CameraSpec> condition) {
    return scenario.cameras().stream().anyMatch(condition);
  }
}
