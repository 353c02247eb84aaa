package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.cells.UsualTarget;
import org.hificamsim.solver.BitMatrix;

/**
 * Finds which points of a demand cameras see in each of their views. It simulates a world in which
 * a target stands at each point, so that lenses, walls, and all else on which sight depends work as
 * in {@code run}. Several threads may use it at once.
 */
public final class PointSight {
  private final Demand demand;
  private final Catalogue catalogue;
  private final TargetSpec usual;

  /** The sites by zone, each with a target at each point of the zone. */
  private final List<Scenario> scenarios = new ArrayList<>();

  /**
   * @param demand the points that are to be seen
   */
  public PointSight(Demand demand, Catalogue catalogue) {
    this.demand = demand;
    this.catalogue = catalogue;
    this.usual = UsualTarget.of(demand.site());
    for (Demand.ZoneDemand zone : demand.zones()) {
      TargetSpec target = targetIn(demand.place(zone));
      List<TargetSpec> targets = new ArrayList<>();
      for (Demand.DemandPoint point : demand.pointsOf(zone)) {
        targets.add(Demand.targetAt(point.x(), point.y(), targets.size(), target));
      }
      scenarios.add(
          demand
              .site()
              .with(Scenario.TARGETS, targets)
              .with(Scenario.EVENTS, List.of())
              .with(Scenario.OCCLUSION, Occlusion.NONE)
              .with(Scenario.CHANNEL, ChannelModel.PERFECT)
              .without(Scenario.VISION_GRAPH));
    }
  }

  /**
   * Returns the usual target, changed so that cameras must see those parts that the zone asks for.
   */
  private TargetSpec targetIn(Zone zone) {
    return zone.seen()
        .filter(seen -> demand.site().hasHeights())
        .map(seen -> usual.with(TargetSpec.SEEN, seen))
        .orElse(usual);
  }

  /** The demand whose points are to be seen. */
  Demand demand() {
    return demand;
  }

  /** Returns a network of these cameras in the views in which they start, without targets. */
  NetworkView network(List<CameraSpec> cameras) {
    return network(demand.site().with(Scenario.CAMERAS, cameras), catalogue);
  }

  /** Returns the network of a site's cameras in the views in which they start, without targets. */
  static NetworkView network(Scenario site, Catalogue catalogue) {
    Scenario withoutTargets =
        site.with(Scenario.TARGETS, List.of())
            .with(Scenario.EVENTS, List.of())
            .with(Scenario.CHANNEL, ChannelModel.PERFECT)
            .without(Scenario.VISION_GRAPH);
    Simulation simulation =
        new Simulation(
            new World(withoutTargets, catalogue.movements(), 0),
            Detection.of(new GeometricDetection()),
            catalogue.policies().create("fixed"),
            0,
            List.of());
    simulation.phases().runUntil(StepPhase.DECIDE);
    return simulation.network();
  }

  /** Returns a world with these cameras, and a target at each point of a zone. */
  public World world(Demand.ZoneDemand zone, List<CameraSpec> cameras) {
    Scenario scenario = scenarios.get(demand.zones().indexOf(zone));
    return new World(scenario.with(Scenario.CAMERAS, cameras), catalogue.movements(), 0);
  }

  /** Returns, by camera and view, the points that the camera sees in the view, rising. */
  public int[][][] seenByView(List<CameraSpec> cameras) {
    int[][][] seen = new int[cameras.size()][][];
    for (Demand.ZoneDemand zone : demand.zones()) {
      if (zone.count() > 0 && !cameras.isEmpty()) {
        Simulation simulation =
            new Simulation(
                world(zone, cameras),
                zone.detection(),
                catalogue.policies().create("fixed"),
                0,
                List.of());
        // targets are located then, and no camera has moved yet
        simulation.phases().runUntil(StepPhase.DECIDE);
        OracleView oracle = simulation.network();
        for (int camera = 0; camera < seen.length; camera++) {
          addSeen(oracle, camera, zone, seen);
        }
      }
    }
    return seen;
  }

  private void addSeen(OracleView oracle, int camera, Demand.ZoneDemand zone, int[][][] seen) {
    int words = BitMatrix.wordsFor(zone.count());
    long[] masks = new long[oracle.views(camera) * words];
    oracle.detections(camera, masks, words);
    Zone place = demand.place(zone);
    if (seen[camera] == null) {
      seen[camera] = new int[oracle.views(camera)][0];
    }
    for (int view = 0; view < seen[camera].length; view++) {
      double z = oracle.zoom(camera, view).vertical().z();
      int[] points =
          BitSet.valueOf(Arrays.copyOfRange(masks, view * words, (view + 1) * words)).stream()
              .map(point -> zone.first() + point)
              .filter(point -> !place.asksForFaces() || shows(place, oracle, camera, z, point))
              .toArray();
      seen[camera][view] =
          IntStream.concat(Arrays.stream(seen[camera][view]), Arrays.stream(points)).toArray();
    }
  }

  /** Whether a camera in its present view sees a face at a point in the way that its zone asks. */
  public boolean showsFace(NetworkView network, int camera, Demand.ZoneDemand zone, int point) {
    double z = network.zoom(camera, network.seeing(camera)).vertical().z();
    return shows(demand.place(zone), network, camera, z, point);
  }

  private boolean shows(Zone place, NetworkView network, int camera, double z, int point) {
    Demand.DemandPoint face = demand.points().get(point);
    double east = network.cameraX(camera) - face.x();
    double north = network.cameraY(camera) - face.y();
    return place.showsFace(east, north, z - usual.height());
  }

  /** Returns, by camera, the points that the camera covers according to a reading, rising. */
  public int[][] covered(List<CameraSpec> cameras, CoverageReading reading) {
    int[][][] seen = seenByView(cameras);
    Cameras mounted = world(demand.zones().get(0), cameras).cameras();
    int[][] covered = new int[seen.length][];
    for (int camera = 0; camera < seen.length; camera++) {
      covered[camera] =
          reading == CoverageReading.FIXED
              ? seen[camera][mounted.view(camera)]
              : union(Arrays.stream(seen[camera]));
    }
    return covered;
  }

  /** Returns the points that are in any of several lists, rising. */
  static int[] union(Stream<int[]> lists) {
    return lists.flatMapToInt(Arrays::stream).sorted().distinct().toArray();
  }
}
