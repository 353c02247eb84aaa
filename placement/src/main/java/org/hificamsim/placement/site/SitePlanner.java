package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.presentation.view.Planner;
import org.hificamsim.runs.cells.FieldCells;

/**
 * Plans one camera at a time while a site is edited, by coarse cells and places, by some view of
 * cameras that turn.
 *
 * @param detections finds those of zones by their names
 */
public record SitePlanner(Catalogue catalogue, Function<String, Detection> detections)
    implements Planner {
  private static final int PARTS = 30; // of the longer side: cells, and places
  private static final long LONGEST = 1_500_000_000; // nanoseconds, for a suggestion

  @Override
  public List<Share> shares(Scenario site, Detection detection) {
    Demand demand = demand(site, detection);
    int[] counts = counts(new SampleSight(demand, catalogue), demand, site.cameras());
    return demand.zones().stream()
        .map(zone -> new Share(zone.name(), demand.share(zone, counts, false)))
        .toList();
  }

  private Demand demand(Scenario site, Detection detection) {
    FieldCells cells = FieldCells.of(site.field(), PARTS);
    return Demand.of(site, cells, Optional.empty(), detection, detections, Optional.empty());
  }

  private static int[] counts(SampleSight sight, Demand demand, List<CameraSpec> cameras) {
    int[] counts = new int[demand.samples().size()];
    for (int[] seen : sight.covered(cameras, CoverageReading.ANY)) {
      Arrays.stream(seen).forEach(sample -> counts[sample]++);
    }
    return counts;
  }

  @Override
  public CameraSpec suggest(Scenario site, Detection detection, Optional<CameraSpec> moved) {
    long started = System.nanoTime();
    Demand demand = demand(site, detection);
    CoverInstance open =
        new CoverInstance(demand.units(), demand.needs(), new int[0][], new double[0]);
    SampleSight sight = new SampleSight(demand, catalogue);
    List<CameraSpec> others =
        site.cameras().stream().filter(one -> !moved.equals(Optional.of(one))).toList();
    int[] counts = counts(sight, demand, others);
    double most =
        moved
            .map(one -> open.gain(counts, sight.covered(List.of(one), CoverageReading.ANY)[0]))
            .orElse(0.0);
    double longer = Math.max(site.field().width(), site.field().height());
    List<Point> places = new ArrayList<>(MountPoints.of(site, longer / PARTS, false, List.of()));
    Collections.shuffle(places, new Random(0)); // where time ends, some are tried everywhere
    List<CameraKind> kinds =
        CameraKind.of(site.name(), moved.map(Stream::of).orElseGet(site::everyCamera));
    Candidate best = null;
    for (Point place : places) {
      if (System.nanoTime() - started > LONGEST) {
        break;
      }
      Candidates here = Candidates.of(List.of(place), kinds, CoverageReading.ANY, sight, 1);
      for (int i = 0; i < here.all().size(); i++) {
        double gain = open.gain(counts, here.columns()[i]);
        if (gain > most + 1e-9) {
          most = gain;
          best = here.all().get(i);
        }
      }
    }
    if (best == null) {
      throw new InputException("no place was found where a camera sees more");
    }
    CameraSpec found = best.camera("suggested");
    Optional<Double> z = best.z();
    return moved
        .map(
            one ->
                one.with(CameraSpec.X, found.x())
                    .with(CameraSpec.Y, found.y())
                    .with(CameraSpec.Z, z)
                    .with(CameraSpec.TILT, found.tilt())
                    .with(CameraSpec.HEADING, found.heading()))
        .orElse(found);
  }
}
