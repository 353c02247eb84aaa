package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.ZoneArea;

/**
 * The part of each zone's area that cameras see. The search covers samples; between these less may
 * be seen, so a plan's claim is of the area.
 */
public record PlanArea(List<MeasuredZone> zones) {
  /**
   * A zone that was measured.
   *
   * @param share the share that is seen as the zone demands, in [0, 1]; NaN if the zone has no free
   *     area
   * @param squareMetres its area outside obstacles
   * @param weight the weight of the zone among all, as {@code run} weighs it
   * @param blindSpots where something is missing, the largest first
   */
  public record MeasuredZone(
      double share, double squareMetres, double weight, List<BlindSpot> blindSpots) {}

  /** Measures the cameras of a plan. */
  public static PlanArea of(
      Demand demand, PointSight sight, List<CameraSpec> cameras, CoverageReading reading) {
    return of(demand, sight, cameras, reading, () -> {});
  }

  /**
   * Measures the cameras of a plan.
   *
   * @param measured action to run after each zone has been measured
   */
  static PlanArea of(
      Demand demand,
      PointSight sight,
      List<CameraSpec> cameras,
      CoverageReading reading,
      Runnable measured) {
    NetworkView network = sight.network(cameras);
    List<MeasuredZone> zones = new ArrayList<>();
    for (ZoneDemand zone : demand.zones()) {
      zones.add(measure(zone.name(), demand.area(zone), network, reading));
      measured.run();
    }
    return new PlanArea(List.copyOf(zones));
  }

  private static MeasuredZone measure(
      String name, ZoneArea area, NetworkView network, CoverageReading reading) {
    double share =
        reading == CoverageReading.FIXED ? area.met(network) : area.metByAnyView(network);
    return new MeasuredZone(
        share,
        area.squareMetres(),
        area.weight(),
        BlindSpot.of(name, area.cells(), area.missing()));
  }

  /** The mean of the zones' shares, by their weights. */
  public double share() {
    double met = 0;
    double total = 0;
    for (MeasuredZone zone : zones) {
      met += zone.weight > 0 ? zone.weight * zone.share : 0;
      total += zone.weight;
    }
    return met / total;
  }

  /** The blind spots of all zones, the largest first. */
  List<BlindSpot> blindSpots() {
    return BlindSpot.largestFirst(zones.stream().flatMap(zone -> zone.blindSpots.stream()));
  }
}
