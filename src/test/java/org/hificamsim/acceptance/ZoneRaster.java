package org.hificamsim.acceptance;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Settings;

/** What is claimed of zones, and a check of it by people on a fine raster. */
final class ZoneRaster {
  private static final Pattern ZONE = Pattern.compile("zone ([^:]+): ([0-9.]+) %");
  private static final double RASTER = 0.05;
  private static final Catalogue CATALOGUE = Catalogue.load();

  private ZoneRaster() {}

  /** The shares of zones that a command prints, percent. */
  static Map<String, Double> claims(String output) {
    return ZONE.matcher(output)
        .results()
        .collect(Collectors.toMap(line -> line.group(1), line -> Double.valueOf(line.group(2))));
  }

  /** Puts a person on each free point of a raster, and counts those that enough cameras detect. */
  static double share(Scenario planned, Zone zone) {
    Zone asked = zone.withDefaults("oodpcvs-2025:level=perceive", planned.objective());
    TargetSpec person = planned.targets().get(0);
    Obstacles obstacles = new Obstacles(planned.obstacles());
    List<TargetSpec> people = new ArrayList<>();
    for (double x = zone.points().get(0).x() + RASTER / 2; x < zone.points().get(1).x(); ) {
      for (double y = zone.points().get(0).y() + RASTER / 2; y < zone.points().get(1).y(); ) {
        if (obstacles.containing(x, y).isEmpty()) {
          people.add(
              person
                  .with(TargetSpec.FEATURES, (double) people.size())
                  .with(TargetSpec.X, x)
                  .with(TargetSpec.Y, y)
                  .with(TargetSpec.SPEED, 0.0));
        }
        y += RASTER;
      }
      x += RASTER;
    }
    Simulation simulation =
        new Simulation(
            new World(planned.with(Scenario.TARGETS, people), CATALOGUE.movements(), 0),
            detection(asked.detection()),
            CATALOGUE.policies().create("fixed"),
            0,
            List.of());
    simulation.step();
    double met = 0;
    for (int target = 0; target < people.size(); target++) {
      int number = target;
      TargetSpec face = people.get(target);
      long cameras =
          IntStream.range(0, planned.cameras().size())
              .filter(camera -> simulation.network().sees(camera, number))
              .filter(camera -> isFaced(face, planned.cameras().get(camera), zone))
              .count();
      met += Math.min(1, cameras / (double) asked.k());
    }
    return met / people.size();
  }

  /** Compares angles by scalar products of directions, not by headings. */
  private static boolean isFaced(TargetSpec face, CameraSpec camera, Zone zone) {
    if (zone.facing() == null) {
      return true;
    }
    Vector3D toCamera =
        new Vector3D(camera.x() - face.x(), camera.y() - face.y(), 3 - face.height());
    Vector3D level = new Vector3D(toCamera.getX(), toCamera.getY(), 0);
    double heading = Math.toRadians(zone.facing());
    Vector3D look = new Vector3D(Math.sin(heading), Math.cos(heading), 0);
    return Math.toDegrees(Vector3D.angle(look, level)) <= zone.facingTolerance()
        && Math.toDegrees(Vector3D.angle(level, toCamera)) <= zone.maxDepression();
  }

  static Detection detection(String name) {
    return DetectionSpec.parse(name, CATALOGUE::detection).detection(Settings.NONE);
  }
}
