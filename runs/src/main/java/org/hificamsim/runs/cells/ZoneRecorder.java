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
 * Measures which share of a scenario's zones is seen as the zones demand, as the mean over the
 * steps of a run. A zone's free cells count equally; a cell that fewer than its k cameras see
 * counts in part. {@code place} counts in the same way.
 */
public final class ZoneRecorder implements StepListener {
  /** The number of cells along the longer side of the field. */
  private static final int CELLS = 60;

  private final List<Watched> zones;

  /**
   * @param size of targets, metres
   * @param usual the detection of zones that name none
   * @param detections finds a detection by the name that a zone has
   */
  public ZoneRecorder(
      Scenario site, double size, Detection usual, Function<String, Detection> detections) {
    FieldCells cells = FieldCells.of(site.field(), CELLS);
    Obstacles obstacles = new Obstacles(site.obstacles());
    int[] free =
        IntStream.range(0, cells.count())
            .filter(cell -> obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty())
            .toArray();
    zones =
        site.zones().stream()
            .map(zone -> zone.withDefaults(usual.name(), site.objective()))
            .filter(zone -> zone.weight() > 0)
            .map(
                zone -> {
                  String name = zone.detection();
                  Detection detection = name.equals(usual.name()) ? usual : detections.apply(name);
                  ViewCells views = new ViewCells(cells, detection, obstacles, size);
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

  /** The weighted mean of the shares of all zones; NaN without zones. */
  public double met() {
    double weights = zones.stream().mapToDouble(Watched::weight).sum();
    return zones.stream().mapToDouble(zone -> zone.weight() * zone.met()).sum() / weights;
  }

  /** The least share of a zone; NaN without zones. */
  public double least() {
    return zones.stream().mapToDouble(Watched::met).min().orElse(Double.NaN);
  }

  /** A zone with what is seen of it. */
  private static final class Watched {
    private final Zone zone;
    private final int[] cells;
    private final ViewCells views;
    private final double[] camerasByCell;

    /** What each camera saw in the last step. */
    private ViewCells.Seen[] seenByCamera = {};

    private double share;
    private double sumOfShares;
    private long steps;

    Watched(Zone zone, FieldCells field, int[] freeCells, ViewCells views) {
      this.zone = zone;
      this.cells =
          Arrays.stream(freeCells)
              .filter(cell -> zone.contains(field.x(cell), field.y(cell)))
              .toArray();
      this.views = views;
      this.camerasByCell = new double[field.count()];
    }

    void step(NetworkView network) {
      ViewCells.Seen[] now = views.now(network);
      if (now != seenByCamera) {
        seenByCamera = now;
        share = share();
      }
      sumOfShares += share;
      steps++;
    }

    private double share() {
      Arrays.fill(camerasByCell, 0);
      for (ViewCells.Seen seen : seenByCamera) {
        for (int i = 0; i < seen.cells().length; i++) {
          camerasByCell[seen.cells()[i]] += seen.chances()[i];
        }
      }
      double met = 0;
      for (int cell : cells) {
        met += Math.min(1, camerasByCell[cell] / zone.k());
      }
      return met / cells.length;
    }

    double weight() {
      return zone.weight() * cells.length;
    }

    double met() {
      return sumOfShares / steps;
    }
  }
}
