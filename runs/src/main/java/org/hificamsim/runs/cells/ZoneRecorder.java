package org.hificamsim.runs.cells;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * How much of a scenario's zones is seen as they ask, over the steps of a run: of the free cells,
 * as {@code place} has them; those that fewer than k cameras see count for a part.
 */
public final class ZoneRecorder implements StepListener {
  private static final int MOST = 60; // cells along the longer side

  private final List<Watched> zones;

  /**
   * @param size of targets, metres
   * @param usual the detection of zones that name none
   * @param detections finds those that they name
   */
  public ZoneRecorder(
      Scenario site, double size, Detection usual, Function<String, Detection> detections) {
    FieldCells cells = FieldCells.of(site.field(), MOST);
    Obstacles obstacles = new Obstacles(site.obstacles());
    int[] free =
        IntStream.range(0, cells.count())
            .filter(cell -> obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty())
            .toArray();
    zones =
        site.zones().stream()
            .map(zone -> zone.asking(usual.name(), site.objective()))
            .filter(zone -> zone.weight() > 0)
            .map(
                zone -> {
                  boolean own = !zone.detection().equals(usual.name());
                  Detection seeing = own ? detections.apply(zone.detection()) : usual;
                  ViewCells views = new ViewCells(cells, seeing, obstacles, size);
                  return new Watched(zone, cells, free, views);
                })
            .filter(zone -> zone.cells.length > 0)
            .toList();
  }

  @Override
  public void started(OracleView network) {
    zones.forEach(zone -> zone.views.forget(network));
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    zones.forEach(zone -> zone.step(network));
  }

  /** The share that is met, by weight; NaN without zones. */
  public double met() {
    double all = zones.stream().mapToDouble(Watched::weight).sum();
    return zones.stream().mapToDouble(zone -> zone.weight() * zone.met()).sum() / all;
  }

  /** The share that is met of the zone of which least is; NaN without zones. */
  public double least() {
    return zones.stream().mapToDouble(Watched::met).min().orElse(Double.NaN);
  }

  private static final class Watched {
    private final Zone zone;
    private final int[] cells;
    private final ViewCells views;
    private final double[] counts; // of cameras, by cell
    private ViewCells.Seen[] seen = {}; // by each camera, in the last step
    private double share;
    private double sum;
    private long steps;

    Watched(Zone zone, FieldCells all, int[] free, ViewCells views) {
      this.zone = zone;
      this.cells =
          Arrays.stream(free).filter(cell -> zone.contains(all.x(cell), all.y(cell))).toArray();
      this.views = views;
      this.counts = new double[all.count()];
    }

    void step(NetworkView network) {
      ViewCells.Seen[] now = views.now(network);
      if (now != seen) {
        seen = now;
        share = share();
      }
      sum += share;
      steps++;
    }

    private double share() {
      Arrays.fill(counts, 0);
      for (ViewCells.Seen one : seen) {
        for (int i = 0; i < one.cells().length; i++) {
          counts[one.cells()[i]] += one.chances()[i];
        }
      }
      double met = 0;
      for (int cell : cells) {
        met += Math.min(1, counts[cell] / zone.k());
      }
      return met / cells.length;
    }

    double weight() {
      return zone.weight() * cells.length;
    }

    double met() {
      return sum / steps;
    }
  }
}
