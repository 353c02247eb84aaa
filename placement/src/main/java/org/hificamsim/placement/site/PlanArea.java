package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.ZoneArea;

/**
 * What cameras see of the area of each zone. The search covers samples; between these less may be
 * seen, so a plan's claim is of the area.
 *
 * @param shares of each zone's area that is seen as the zone demands, in [0, 1]
 */
public record PlanArea(List<Double> shares) {
  /** Measures the cameras of a plan. */
  public static PlanArea of(
      Demand demand, PointSight sight, List<CameraSpec> cameras, CoverageReading reading) {
    return of(demand, sight, cameras, reading, () -> {});
  }

  /**
   * Measures the cameras of a plan.
   *
   * @param measured is told of each zone that has been measured
   */
  static PlanArea of(
      Demand demand,
      PointSight sight,
      List<CameraSpec> cameras,
      CoverageReading reading,
      Runnable measured) {
    NetworkView network = sight.network(cameras);
    List<Double> shares = new ArrayList<>();
    for (ZoneDemand zone : demand.zones()) {
      shares.add(share(demand.area(zone), network, reading));
      measured.run();
    }
    return new PlanArea(List.copyOf(shares));
  }

  private static double share(ZoneArea area, NetworkView network, CoverageReading reading) {
    return reading == CoverageReading.FIXED ? area.met(network) : area.metByAnyView(network);
  }

  /** The mean of the zones' shares, by their weights in a demand. */
  public double of(Demand demand) {
    double met = 0;
    double total = 0;
    for (int number = 0; number < shares.size(); number++) {
      ZoneDemand zone = demand.zones().get(number);
      met += demand.weight(zone) * (zone.count() == 0 ? 0 : shares.get(number));
      total += demand.weight(zone);
    }
    return met / total;
  }
}
