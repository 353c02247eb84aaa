package org.hificamsim.network;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;

/** Reads a scenario file with CamSim's order of a step, ranges and movements. */
public final class CamSimScenario {
  private CamSimScenario() {}

  /**
   * Reads the file.
   *
   * @param movement the class name of the movement of all objects; null for those of the file
   * @param zooming whether to keep the zoom list of the file, which CamSim ignores
   * @throws InputException if the file is invalid, or an object has no path for its movement
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
                settings.check(),
                warning -> err.println("warning: " + Place.printable(warning)))
            .with(Scenario.ORDER, StepOrder.CAMSIM);
    warnAboutDefaults(file, scenario, settings, err);
    if (scenario.hasHeights()) {
      err.println("warning: " + file + ": CamSim's world is flat, heights are left out");
      scenario = scenario.flat();
    }
    if (!zooming) {
      scenario = scenario.with(Scenario.ZOOMS, List.of());
    }
    if (movement != null) {
      scenario = scenario.withMovement(movement);
    }
    Scenario read = withQuirks(scenario, settings);
    requirePaths(read, movement == null ? file.toString() : "-m '" + movement + "'");
    return read;
  }

  /**
   * Applies the quirks of movement that the settings ask for. A scenario with a zoom list keeps the
   * waypoints of the coverage study, which have speeds of their own.
   */
  public static Scenario withQuirks(Scenario scenario, NetworkSettings settings) {
    Scenario read = scenario;
    if (!settings.has(Quirk.EVENT_MOVE_IGNORED)) {
      read = read.withTargets(CamSimScenario::withMovementFromMove);
    }
    return settings.has(Quirk.WAYPOINT_SPEED_IS_HEADING) && !scenario.inCoverageDialect()
        ? read.withTargets(target -> withHeadingAsSpeed(target, scenario.headings()))
        : read;
  }

  /** Takes the movement of an added object from {@code move} if {@code fqName} is missing. */
  private static TargetSpec withMovementFromMove(TargetSpec target) {
    String movement = target.extras().getOrDefault("move", "");
    return target.origin() == TargetSpec.Origin.EVENT && target.get(TargetSpec.MOVE).isEmpty()
        ? target.withMovement(movement)
        : target;
  }

  /** Sets the speed to the heading in radians if a class name selects the waypoints. */
  private static TargetSpec withHeadingAsSpeed(TargetSpec target, Headings headings) {
    boolean namedByClass = !target.get(TargetSpec.MOVE).isEmpty();
    return namedByClass && target.movement().equals("Waypoints")
        ? target.with(TargetSpec.SPEED, headings.radians(target.heading()))
        : target;
  }

  /** Requires a path for every object that follows one; errors begin with {@code source}. */
  private static void requirePaths(Scenario scenario, String source) {
    scenario
        .everyTarget()
        .filter(target -> target.lacksWaypoints() || target.lacksTrack())
        .findFirst()
        .ifPresent(
            target -> {
              throw InputException.of(
                  "%s: object %s has no %s for movement %s",
                  source,
                  target.name(),
                  target.lacksTrack()
                      ? "track, expected one of <tracks>"
                      : "waypoints, expected at least two",
                  target.movement());
            });
  }

  private static void warnAboutDefaults(
      Path file, Scenario scenario, NetworkSettings settings, PrintWriter err) {
    List<String> missing = new ArrayList<>();
    boolean named = !settings.strategies().isEmpty();
    if (!named
        && settings.schedule().isEmpty()
        && lacks(scenario, camera -> camera.find(CameraSpec.ALGORITHM).isEmpty())) {
      missing.add("ai_algorithm, taken as Active");
    }
    if (!named
        && settings.communication().isEmpty()
        && lacks(scenario, camera -> camera.find(CameraSpec.COMM).isEmpty())) {
      missing.add("comm, taken as 0");
    }
    if (!missing.isEmpty()) {
      err.println(
          "warning: %s: cameras without %s".formatted(file, String.join(", and ", missing)));
    }
  }

  private static boolean lacks(Scenario scenario, Predicate<CameraSpec> condition) {
    return scenario.cameras().stream().anyMatch(condition);
  }
}
