package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.presentation.view.Planner;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.ZoneArea;
import org.hificamsim.solver.cover.CoverInstance;

/**
 * Plans cameras while a site is edited. To be fast, it uses large cells and few mount points. A
 * point is covered if it is in any view of a camera that turns.
 *
 * @param detections finds the detection that a zone names
 * @param prices the cameras that can be bought
 */
public record SitePlanner(
    Catalogue catalogue, Function<String, Detection> detections, PriceList prices)
    implements Planner {
  /** The number of mount points, and the least number of cells, along the field's longer side. */
  private static final int PARTS = 30;

  private static final Sampling SAMPLING = new Sampling(PARTS, FieldCells.MAX);

  /**
   * The tilt of cameras that are mounted by hand on sites with heights, in degrees below the
   * horizon.
   */
  private static final double USUAL_TILT = 15;

  private static final long MAX_NANOSECONDS = 1_500_000_000;

  private static final Candidates.Work ONE_PLACE = new Candidates.Work(1, () -> false, () -> {});

  @Override
  public List<Share> shares(Scenario site, Detection detection) {
    NetworkView network = PointSight.network(site, catalogue);
    return Zone.ofSite(site.zones()).stream()
        .map(zone -> new Share(zone.name(), area(site, zone, detection).metByAnyView(network)))
        .toList();
  }

  private ZoneArea area(Scenario site, Zone zone, Detection usual) {
    return ZoneArea.of(site, zone, usual, detections);
  }

  private Demand demand(Scenario site, Detection detection) {
    Demand.Detections siteDetections = new Demand.Detections(detection, detections);
    return Demand.of(site, SAMPLING, Optional.empty(), siteDetections, Optional.empty());
  }

  private static int[] counts(PointSight sight, Demand demand, List<CameraSpec> cameras) {
    int[] counts = new int[demand.points().size()];
    for (int[] covered : sight.covered(cameras, CoverageReading.ANY)) {
      Arrays.stream(covered).forEach(point -> counts[point]++);
    }
    return counts;
  }

  @Override
  public CameraSpec suggest(Scenario site, Detection detection, Optional<CameraSpec> moved) {
    long deadline = System.nanoTime() + MAX_NANOSECONDS;
    Demand demand = demand(site, detection);
    PointSight sight = new PointSight(demand, catalogue);
    List<CameraSpec> others =
        site.cameras().stream().filter(camera -> !moved.equals(Optional.of(camera))).toList();
    int[] counts = counts(sight, demand, others);
    CoverInstance instance =
        new CoverInstance(demand.unitWorths(), demand.needs(), new int[0][], new double[0]);
    double greatestGain = 0;
    if (moved.isPresent()) {
      int[] covered = sight.covered(List.of(moved.get()), CoverageReading.ANY)[0];
      greatestGain = instance.gain(counts, covered);
    }
    List<Point> points = shuffledMountPoints(site);
    List<CameraKind> kinds = kinds(site, moved);
    Candidate best = null;
    for (Point point : points) {
      if (System.nanoTime() > deadline) {
        break;
      }
      Candidates.Options options = new Candidates.Options(List.of(point), kinds);
      Candidates candidates = Candidates.of(options, CoverageReading.ANY, sight, ONE_PLACE);
      for (int i = 0; i < candidates.list().size(); i++) {
        double gain = instance.gain(counts, candidates.covered()[i]);
        if (gain > greatestGain + 1e-9) {
          greatestGain = gain;
          best = candidates.list().get(i);
        }
      }
    }
    if (best == null) {
      throw new InputException("no place was found where a camera sees more");
    }
    return moved.isPresent() ? onMount(moved.get(), best) : best.camera("suggested");
  }

  /**
   * Returns the kind of the moved camera or, for a new one, those of the site's cameras; on a site
   * without cameras, all kinds that can be bought.
   */
  private List<CameraKind> kinds(Scenario site, Optional<CameraSpec> moved) {
    return moved.isEmpty() && site.everyCamera().findAny().isEmpty()
        ? prices.kinds()
        : CameraKind.of(site.name(), moved.isPresent() ? moved.stream() : site.everyCamera());
  }

  @Override
  public List<String> kinds() {
    return prices.names();
  }

  @Override
  public CameraSpec mounted(Mount request, Scenario site) {
    CameraKind kind = prices.kind(request.kind());
    double tilt = site.hasHeights() ? USUAL_TILT : 0;
    Point position = new Point(request.x(), request.y());
    Mounting mount = new Mounting(position, Mounting.newHeightOn(site), tilt, request.heading());
    return new Candidate(kind, kind.setTo(request.angle()), mount)
        .camera(kind.name())
        .with(CameraSpec.PRICE, kind.price());
  }

  @Override
  public Plan plan(Scenario site, Detection detection, Request request, Watcher watcher) {
    List<Point> points = mountPoints(site, request.ceiling());
    return new QuickPlan(catalogue, demand(site, detection), points, request)
        .find(prices.kinds(), watcher);
  }

  /** The mount points in random order: if the time is short, those tried lie all over the site. */
  private static List<Point> shuffledMountPoints(Scenario site) {
    List<Point> points = new ArrayList<>(mountPoints(site, false));
    Collections.shuffle(points, new Random(0));
    return points;
  }

  private static List<Point> mountPoints(Scenario site, boolean ceiling) {
    double longerSide = Math.max(site.field().width(), site.field().height());
    MountPoints.Rules rules =
        new MountPoints.Rules(longerSide / PARTS, MountPoints.CLEARANCE, ceiling, List.of());
    return MountPoints.of(site, rules);
  }

  /** Returns a camera on the mount of a candidate. */
  private static CameraSpec onMount(CameraSpec camera, Candidate candidate) {
    CameraSpec suggested = candidate.camera("suggested");
    return camera
        .with(CameraSpec.X, suggested.x())
        .with(CameraSpec.Y, suggested.y())
        .with(CameraSpec.Z, candidate.mount().z())
        .with(CameraSpec.TILT, suggested.tilt())
        .with(CameraSpec.HEADING, suggested.heading());
  }
}
