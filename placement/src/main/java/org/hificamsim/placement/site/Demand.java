package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.runs.cells.FieldCells;

/**
 * What is demanded: samples, the middles of cells of the field, zone by zone. A cell in two zones
 * is two samples.
 *
 * @param samples in the order of zones
 */
public record Demand(Scenario site, FieldCells cells, List<Watched> zones, List<Sample> samples) {
  /** A zone with what it means: its detection, k cameras, and its samples. */
  public record Watched(String name, Detection detection, int k, int first, int end) {
    /** How many samples it has. */
    public int count() {
      return end - first;
    }
  }

  /**
   * A place that is to be seen.
   *
   * @param zone the number of its zone
   * @param weight what seeing it is worth, above 0
   */
  public record Sample(double x, double y, int zone, double weight) {}

  /**
   * The demand of a scenario.
   *
   * @param redundancy how many cameras each place needs, in place of what the zones say
   * @param detection of the scenario
   * @param detections finds those of zones by their names
   * @param visits how often targets were in each cell, which weighs them; empty: all alike
   * @throws InputException where there is nothing to be seen
   */
  public static Demand of(
      Scenario site,
      FieldCells cells,
      Optional<Integer> redundancy,
      Detection detection,
      Function<String, Detection> detections,
      Optional<double[]> visits) {
    List<Zone> zones = site.zones().isEmpty() ? List.of(Zone.ofField()) : site.zones();
    int usual = site.objective() instanceof Objective.Covered covered ? covered.k() : 1;
    Obstacles obstacles = new Obstacles(site.obstacles());
    boolean[] free = new boolean[cells.count()];
    for (int cell = 0; cell < free.length; cell++) {
      free[cell] = obstacles.containing(cells.x(cell), cells.y(cell)).isEmpty();
    }
    List<Watched> watched = new ArrayList<>();
    List<Sample> samples = new ArrayList<>();
    for (Zone zone : zones) {
      int first = samples.size();
      for (int cell = 0; cell < free.length && zone.weight() > 0; cell++) {
        double weight = zone.weight() * (visits.isPresent() ? visits.get()[cell] : 1);
        if (free[cell] && weight > 0 && zone.contains(cells.x(cell), cells.y(cell))) {
          samples.add(new Sample(cells.x(cell), cells.y(cell), watched.size(), weight));
        }
      }
      Detection own = zone.detection() == null ? detection : detections.apply(zone.detection());
      requireCertain(zone, own);
      int k = redundancy.orElse(zone.k() == null ? usual : zone.k());
      watched.add(new Watched(zone.name(), own, k, first, samples.size()));
      if (zone.weight() > 0 && samples.size() == first && visits.isEmpty()) {
        throw InputException.of(
            "zone '%s' has no free cell of %s m, expected more %s, or a larger zone",
            zone.name(), cells.width(), setting("cells"));
      }
    }
    if (samples.isEmpty()) {
      throw new InputException("nothing is to be seen, expected a zone with a weight above 0");
    }
    return new Demand(site, cells, watched, samples);
  }

  /** The same places, each asked for by a detection. */
  public Demand by(Detection detection) {
    List<Watched> all =
        zones.stream()
            .map(one -> new Watched(one.name, detection, one.k, one.first, one.end))
            .toList();
    return new Demand(site, cells, all, samples);
  }

  private static void requireCertain(Zone zone, Detection detection) {
    if (!detection.certain()) {
      throw InputException.of(
          "zone '%s' is seen by chance, %s, expected a detection by a threshold",
          zone.name(), detection.name());
    }
  }

  /** The first target of the most frequent size: what stands in samples is as large. */
  public static TargetSpec usualTarget(List<TargetSpec> all) {
    Map<Double, Long> counts =
        all.stream().collect(Collectors.groupingBy(TargetSpec::size, Collectors.counting()));
    return all.stream().max(Comparator.comparingLong(one -> counts.get(one.size()))).orElseThrow();
  }

  /** A target that stands at a place, otherwise like another. */
  public static TargetSpec target(TargetSpec like, int number, double x, double y) {
    return like.with(TargetSpec.FEATURES, (double) number)
        .with(TargetSpec.X, x)
        .with(TargetSpec.Y, y)
        .with(TargetSpec.SPEED, 0)
        .with(TargetSpec.MOVE, "Straight")
        .with(TargetSpec.WAYPOINTS, List.of());
  }

  /** The samples of a zone. */
  List<Sample> samplesOf(Watched zone) {
    return samples.subList(zone.first(), zone.end());
  }

  /** By sample: what each time that it is seen is worth. */
  public double[] units() {
    return samples.stream().mapToDouble(one -> one.weight() / needs(one)).toArray();
  }

  /** By sample: how many cameras it needs. */
  public int[] needs() {
    return samples.stream().mapToInt(this::needs).toArray();
  }

  private int needs(Sample sample) {
    return zones.get(sample.zone()).k();
  }

  /**
   * The share of a zone's demand that is met where samples are seen by this many cameras.
   *
   * @param whole whether those that are seen by fewer than k count for nothing
   */
  public double share(Watched zone, int[] counts, boolean whole) {
    double all = 0;
    double met = 0;
    for (int i : IntStream.range(zone.first(), zone.end()).toArray()) {
      double part = Math.min(1, counts[i] / (double) zone.k());
      all += samples.get(i).weight();
      met += samples.get(i).weight() * (whole ? Math.floor(part) : part);
    }
    return all == 0 ? 1 : met / all;
  }
}
