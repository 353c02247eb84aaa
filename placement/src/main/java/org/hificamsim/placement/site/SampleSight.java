package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;

/**
 * Which samples cameras see in each of their views: a world with a target that stands in each of
 * them, so that lenses, walls and whatever else sight depends on are those of {@code run}.
 */
public final class SampleSight {
  private final Demand demand;
  private final Catalogue catalogue;
  private final List<Scenario> worlds = new ArrayList<>(); // by zone, without cameras

  /**
   * The sight of a site. Any number of threads may ask.
   *
   * @param demand says where the samples are
   */
  public SampleSight(Demand demand, Catalogue catalogue) {
    this.demand = demand;
    this.catalogue = catalogue;
    TargetSpec usual = Demand.usualTarget(demand.site().everyTarget().toList());
    for (Demand.Watched zone : demand.zones()) {
      List<TargetSpec> targets = new ArrayList<>();
      for (Demand.Sample sample : demand.samplesOf(zone)) {
        targets.add(Demand.target(usual, targets.size(), sample.x(), sample.y()));
      }
      worlds.add(
          demand
              .site()
              .with(Scenario.TARGETS, targets)
              .with(Scenario.EVENTS, List.of())
              .with(Scenario.OCCLUSION, Occlusion.NONE)
              .with(Scenario.CHANNEL, ChannelModel.PERFECT)
              .without(Scenario.VISION_GRAPH));
    }
  }

  /** The site as it is. */
  Scenario site() {
    return demand.site();
  }

  /** The world of a zone's samples under these cameras. */
  public World world(Demand.Watched zone, List<CameraSpec> cameras) {
    Scenario site = worlds.get(demand.zones().indexOf(zone));
    return new World(site.with(Scenario.CAMERAS, cameras), catalogue.movements(), 0);
  }

  /** The samples that each camera sees in each of its views, rising: by camera, then view. */
  public int[][][] seen(List<CameraSpec> cameras) {
    int[][][] seen = new int[cameras.size()][][];
    for (Demand.Watched zone : demand.zones()) {
      if (zone.count() > 0 && !cameras.isEmpty()) {
        Simulation simulation =
            new Simulation(
                world(zone, cameras),
                zone.detection(),
                catalogue.policies().create("fixed"),
                0,
                List.of());
        simulation.phases().runUntil(StepPhase.DECIDE);
        OracleView oracle = simulation.network();
        for (int camera = 0; camera < seen.length; camera++) {
          add(oracle, camera, zone, seen);
        }
      }
    }
    return seen;
  }

  private static void add(OracleView oracle, int camera, Demand.Watched zone, int[][][] seen) {
    int words = (zone.count() + Long.SIZE - 1) / Long.SIZE;
    long[] masks = new long[oracle.views(camera) * words];
    oracle.detections(camera, masks, words);
    if (seen[camera] == null) {
      seen[camera] = new int[oracle.views(camera)][0];
    }
    for (int view = 0; view < seen[camera].length; view++) {
      int[] found =
          BitSet.valueOf(Arrays.copyOfRange(masks, view * words, (view + 1) * words)).stream()
              .map(sample -> zone.first() + sample)
              .toArray();
      seen[camera][view] =
          IntStream.concat(Arrays.stream(seen[camera][view]), Arrays.stream(found)).toArray();
    }
  }

  /** The samples that each camera covers by a reading, rising. */
  public int[][] covered(List<CameraSpec> cameras, CoverageReading reading) {
    int[][][] seen = seen(cameras);
    World world = world(demand.zones().get(0), cameras);
    int[][] covered = new int[seen.length][];
    for (int camera = 0; camera < seen.length; camera++) {
      covered[camera] =
          reading == CoverageReading.FIXED
              ? seen[camera][world.cameras().view(camera)]
              : union(Arrays.stream(seen[camera]));
    }
    return covered;
  }

  /** All samples of several lists, rising. */
  static int[] union(Stream<int[]> lists) {
    return lists.flatMapToInt(Arrays::stream).sorted().distinct().toArray();
  }
}
