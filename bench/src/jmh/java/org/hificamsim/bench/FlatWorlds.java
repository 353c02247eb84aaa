package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Settings;

/**
 * Measures the error of a flat world. It compares the share of the floor on which a target is
 * detected between a scenario with heights and the same scenario without them.
 */
public final class FlatWorlds {
  /** The side of a cell of the floor, in metres. */
  private static final double CELL = 0.5;

  private FlatWorlds() {}

  /**
   * Prints two rows for each scenario: one for the views in which cameras start, one for all views.
   *
   * @param args scenario files
   */
  public static void main(String[] args) {
    System.out.println(
        "site, views: seen in the flat world, seen with heights, flat only, heights only");
    for (String file : args) {
      Scenario scenario = ScenarioReader.read(Path.of(file), name -> true, warning -> {});
      for (boolean anyView : new boolean[] {false, true}) {
        print(
            scenario, seen(scenario.flat(), file, anyView), seen(scenario, file, anyView), anyView);
      }
    }
  }

  private static void print(Scenario scenario, boolean[] flat, boolean[] high, boolean anyView) {
    int[] counts = new int[4];
    int floor = 0;
    Field field = scenario.field();
    Obstacles obstacles = new Obstacles(scenario.obstacles());
    for (int i = 0; i < flat.length; i++) {
      if (obstacles.containing(x(field, i), y(field, i)).isEmpty()) {
        floor++;
        counts[(flat[i] ? 2 : 0) + (high[i] ? 1 : 0)]++;
      }
    }
    double percent = 100.0 / floor;
    System.out.printf(
        Locale.ROOT,
        "%s, %s: %.1f %%, %.1f %%, %.1f %%, %.1f %%%n",
        scenario.name(),
        anyView ? "any view" : "the view each camera starts in",
        percent * (counts[2] + counts[3]),
        percent * (counts[1] + counts[3]),
        percent * counts[2],
        percent * counts[1]);
  }

  private static int columns(Field field) {
    return (int) Math.round(field.width() / CELL);
  }

  private static double x(Field field, int cell) {
    return field.minX() + (cell % columns(field) + 0.5) * CELL;
  }

  private static double y(Field field, int cell) {
    return field.minY() + (cell / columns(field) + 0.5) * CELL;
  }

  /**
   * Returns for each cell whether some camera detects a target in its middle.
   *
   * @param anyView whether any view of a camera counts, else only the one in which it starts
   */
  private static boolean[] seen(Scenario scenario, String file, boolean anyView) {
    Catalogue catalogue = Catalogue.load();
    Detection detection = DetectionSpec.of(Settings.NONE, scenario, Path.of(file), catalogue);
    ZoomPolicy idle = catalogue.policies().create("zoom-out");
    World world = new World(scenario, catalogue.movements(), 0);
    NetworkView network = new Simulation(world, detection, idle, 0, List.of()).network();
    Field field = scenario.field();
    boolean[] seen = new boolean[columns(field) * (int) Math.round(field.height() / CELL)];
    double size = scenario.everyTarget().findFirst().orElseThrow().size();
    Body body = network.body(size);
    for (int camera = 0; camera < network.cameras(); camera++) {
      double cameraX = network.cameraX(camera);
      double cameraY = network.cameraY(camera);
      VisibleRegion region = VisibleRegion.of(network.obstacles(), cameraX, cameraY);
      double z = network.zoom(camera, 0).vertical().z();
      double[] chances = new double[network.views(camera)];
      for (int cell = 0; cell < seen.length; cell++) {
        double x = x(field, cell);
        double y = y(field, cell);
        double through = region.transmittance(x, y, z, body.low(), body.high());
        if (through > 0 && network.chancesAt(camera, x, y, size, through, chances)) {
          seen[cell] |= anyView || chances[network.view(camera)] > 0;
        }
      }
    }
    return seen;
  }
}
