package org.hificamsim.acceptance;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.world.World;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.cells.UsualTarget;

/** Reads a plan's claims about zones, and checks them with people on a fine raster. */
final class ZoneRaster {
  private static final Pattern ZONE = Pattern.compile("zone ([^:]+): ([0-9.]+) %");
  private static final double EDGE = 0.1;
  private static final int MAX_CELLS = 90_000;
  private static final int PEOPLE_PER_WORLD = 10_000;
  private static final Catalogue CATALOGUE = Catalogue.load();

  private ZoneRaster() {}

  /** Returns the shares of zones that a command printed, in percent by name of the zone. */
  static Map<String, Double> claims(String output) {
    return ZONE.matcher(output)
        .results()
        .collect(Collectors.toMap(line -> line.group(1), line -> Double.valueOf(line.group(2))));
  }

  /**
   * Returns the share of people in a zone whom enough cameras detect, in [0, 1]. Each free cell of
   * a raster of 0.1 m has a person; a zone with more than 90,000 cells has a coarser raster with
   * that many. A person stands at a random position in the cell, so that edges along the raster
   * cause no error.
   *
   * @param usual the detection of zones that name none
   */
  static double share(Scenario planned, Zone zone, String usual) {
    Zone asked = zone.withDefaults(usual, planned.objective());
    List<Point> places = places(planned, zone);
    double met = 0;
    for (int from = 0; from < places.size(); from += PEOPLE_PER_WORLD) {
      int end = Math.min(places.size(), from + PEOPLE_PER_WORLD);
      met += met(planned, asked, places.subList(from, end));
    }
    return met / places.size();
  }

  private static List<Point> places(Scenario planned, Zone zone) {
    Field bounds = zone.bounds(planned.field());
    double edge = Math.max(EDGE, Math.sqrt(bounds.width() * bounds.height() / MAX_CELLS));
    Obstacles obstacles = new Obstacles(planned.obstacles());
    Random random = new Random(1);
    List<Point> places = new ArrayList<>();
    for (double left = bounds.minX(); left < bounds.maxX(); left += edge) {
      for (double bottom = bounds.minY(); bottom < bounds.maxY(); bottom += edge) {
        double x = left + edge * random.nextDouble();
        double y = bottom + edge * random.nextDouble();
        boolean isInside = bounds.contains(x, y) && zone.contains(x, y);
        if (isInside && obstacles.containing(x, y).isEmpty()) {
          places.add(new Point(x, y));
        }
      }
    }
    return places;
  }

  /** Returns the number of people whom enough cameras detect; fewer cameras count in proportion. */
  private static double met(Scenario planned, Zone asked, List<Point> places) {
    TargetSpec usual = UsualTarget.of(planned);
    TargetSpec person = asked.facing() == null ? usual : usual.with(TargetSpec.SEEN, Seen.FACE);
    List<TargetSpec> people = new ArrayList<>();
    for (Point place : places) {
      people.add(Demand.targetAt(place.x(), place.y(), people.size(), person));
    }
    Scenario crowded =
        planned
            .with(Scenario.TARGETS, people)
            .with(Scenario.EVENTS, List.of())
            .with(Scenario.OCCLUSION, Occlusion.NONE);
    Simulation simulation =
        new Simulation(
            new World(crowded, CATALOGUE.movements(), 0),
            detection(asked.detection()),
            CATALOGUE.policies().create("fixed"),
            0,
            List.of());
    simulation.phases().runUntil(StepPhase.DECIDE);
    double met = 0;
    for (int target = 0; target < people.size(); target++) {
      int number = target;
      TargetSpec face = people.get(target);
      long cameras =
          IntStream.range(0, planned.cameras().size())
              .filter(camera -> simulation.network().sees(camera, number))
              .filter(camera -> isFaced(face, planned.cameras().get(camera), asked))
              .count();
      met += Math.min(1, cameras / (double) asked.k());
    }
    return met;
  }

  /** Whether a camera sees a face as a zone asks, computed by vectors instead of headings. */
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
