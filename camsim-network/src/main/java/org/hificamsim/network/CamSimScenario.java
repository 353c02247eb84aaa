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
    Scenario read = as(scenario, settings);
    requirePaths(read, movement == null ? file.toString() : "-m '" + movement + "'");
    return read;
  }

  /**
   * The scenario with the quirks of movement that are asked for. Where a zoom list counts,
   * waypoints are the coverage study's, at their own speed.
   */
  public static Scenario as(Scenario scenario, NetworkSettings settings) {
    Scenario read = scenario;
    if (!settings.has(Quirk.EVENT_MOVE_IGNORED)) {
      read = read.withTargets(CamSimScenario::withAlias);
    }
    return settings.has(Quirk.WAYPOINT_SPEED_IS_HEADING) && !scenario.inCoverageDialect()
        ? read.withTargets(target -> withSwap(target, scenario.headings()))
        : read;
  }

  /** An event's {@code move} names its movement where {@code fqName} does not. */
  private static TargetSpec withAlias(TargetSpec target) {
    String alias = target.extras().getOrDefault("move", "");
    return target.origin() == TargetSpec.Origin.EVENT && target.get(TargetSpec.MOVE).isEmpty()
        ? target.withMovement(alias)
        : target;
  }

  /** Speed becomes the heading in radians where a class name leads to waypoints. */
  private static TargetSpec withSwap(TargetSpec target, Headings headings) {
    boolean throughClassName = !target.get(TargetSpec.MOVE).isEmpty();
    return throughClassName && target.movement().equals("Waypoints")
        ? target.with(TargetSpec.SPEED, headings.radians(target.heading()))
        : target;
  }

  /** An error, which {@code source} is to blame for, where a path is to be followed without one. */
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
        && settings.comm().isEmpty()
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
