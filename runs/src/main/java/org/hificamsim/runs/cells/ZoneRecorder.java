package org.hificamsim.runs.cells;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * Measures the share of a scenario's zones that is seen as they demand, the mean over the steps of
 * a run; see {@link ZoneArea}.
 */
public final class ZoneRecorder implements StepListener {
  private final List<WatchedZone> zones;

  /**
   * @param usual the detection of zones that name none
   * @param detections finds a detection by the name that a zone has
   */
  public ZoneRecorder(Scenario site, Detection usual, Function<String, Detection> detections) {
    zones =
        site.zones().stream()
            .filter(zone -> zone.weight() > 0)
            .map(zone -> new WatchedZone(zone, ZoneArea.of(site, zone, usual, detections)))
            .filter(zone -> !zone.area.isEmpty())
            .toList();
  }

  @Override
  public void started(OracleView network) {
    zones.forEach(zone -> zone.area.forget(network));
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    zones.forEach(zone -> zone.step(network));
  }

  /** The weighted mean of the shares of all zones; NaN without zones. */
  public double met() {
    double weights = zones.stream().mapToDouble(zone -> zone.area.weight()).sum();
    return zones.stream().mapToDouble(zone -> zone.area.weight() * zone.met()).sum() / weights;
  }

  /** The least share of a zone; NaN without zones. */
  public double least() {
    return zones.stream().mapToDouble(WatchedZone::met).min().orElse(Double.NaN);
  }

  /** The share of each zone, by the zone's name. */
  public Map<String, Double> shares() {
    Map<String, Double> shares = new LinkedHashMap<>();
    zones.forEach(zone -> shares.put(zone.name, zone.met()));
    return shares;
  }

  /** A zone with the sum of its shares over the steps. */
  private static final class WatchedZone {
    private final String name;
    private final ZoneArea area;
    private double sumOfShares;
    private long steps;

    WatchedZone(Zone zone, ZoneArea area) {
      this.name = zone.name();
      this.area = area;
    }

    void step(OracleView network) {
      sumOfShares += area.met(network);
      steps++;
    }

    double met() {
      return sumOfShares / steps;
    }
  }
}
