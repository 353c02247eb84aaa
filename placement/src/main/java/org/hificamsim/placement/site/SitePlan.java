package org.hificamsim.placement.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.UsualTarget;

/**
 * Cameras for a site, and how good they are.
 *
 * @param planned the cameras that stay, then the new ones
 * @param area what the cameras see of each zone's area
 * @param coverPlan what the search found: candidates of {@code problem}, before any refinement
 */
public record SitePlan(
    PlacementProblem problem,
    List<PlannedCamera> planned,
    PlanArea area,
    CoverPlan coverPlan,
    Shares shares) {

  /**
   * A camera of the plan.
   *
   * @param price 0 if the camera stays
   * @param covered the points that it covers, rising
   */
  public record PlannedCamera(CameraSpec camera, double price, int[] covered) {}

  /**
   * Shares of the demand, in [0, 1].
   *
   * @param unrefined what {@code coverPlan} meets, if its cameras were refined
   * @param bound no plan of the same candidates meets more
   * @param ofSite what the cameras of the site meet as it is
   */
  public record Shares(Optional<Double> unrefined, double bound, double ofSite) {}

  public Demand demand() {
    return problem.demand();
  }

  /** The cameras that stay, then the new ones, as elements of a scenario. */
  public List<CameraSpec> cameras() {
    return planned.stream().map(PlannedCamera::camera).toList();
  }

  /** By point, the number of cameras that cover it. */
  public int[] counts() {
    return countsWithout(-1);
  }

  /** By point, the number of cameras that cover it after the failure of one. */
  public int[] countsWithout(int failed) {
    int[] counts = new int[demand().points().size()];
    for (int camera = 0; camera < planned.size(); camera++) {
      if (camera != failed) {
        count(counts, camera);
      }
    }
    return counts;
  }

  private void count(int[] counts, int camera) {
    for (int point : planned.get(camera).covered) {
      counts[point]++;
    }
  }

  /** The share of the demand that is met if points are covered this often. */
  public double share(int[] counts) {
    return problem.share(counts);
  }

  /** The share of the demand that the plan meets. */
  public double share() {
    return share(counts());
  }

  /** What is claimed to be met: a share of the area, or of where targets are. */
  public double claimedShare() {
    return demand().isForArea() ? area.of(demand()) : share();
  }

  /** What is claimed to be met of a zone. */
  public double claimedShare(ZoneDemand zone) {
    return demand().isForArea()
        ? area.shares().get(demand().zones().indexOf(zone))
        : demand().share(zone, counts());
  }

  /** How good the plan is, in lines for people; what is met comes first. */
  public List<String> facts() {
    List<String> facts = new ArrayList<>();
    facts.add(
        Texts.format(
            "%s, %d of them kept, price %.2f: %.2f %% of the demand is met",
            Texts.counted(planned.size(), "camera"),
            problem.kept().size(),
            price(),
            100 * claimedShare()));
    if (demand().isForArea()) {
      facts.add(
          Texts.format(
              "measured on the area; the search and its bound are of samples, of which %.2f %% is"
                  + " met",
              100 * share()));
    }
    facts.add(problem.request().reading().words() + refinementFact());
    if (problem.goal().isFullCover()) {
      facts.add(
          Texts.format(
              "no plan costs less than %.2f: gap %.2f %%",
              coverPlan.bound(), 100 * coverPlan.gap()));
      facts.add(Texts.format("all candidates together meet %.2f %%", 100 * shares.bound));
    } else {
      double found = shares.unrefined.orElse(share());
      facts.add(
          Texts.format("no plan of these candidates meets more than %.2f %%", 100 * shares.bound));
      facts.add(Texts.format("gap %.2f %%", 100 * (1 - found / shares.bound)));
    }
    if (coverPlan.isProven()) {
      facts.add("proven: no plan of these candidates is better");
    }
    facts.add(
        Texts.format(
            "the site's own cameras (%d) meet %.2f %%",
            demand().site().cameras().size(), 100 * shares.ofSite));
    return facts;
  }

  private String refinementFact() {
    if (shares.unrefined.isEmpty()) {
      return "";
    }
    double before = shares.unrefined.get();
    return Texts.format(
        "; refined from a plan of candidates that meets %.2f %%, a gain of %.2f points",
        100 * before, 100 * (share() - before));
  }

  /** The price of all new cameras. */
  public double price() {
    return planned.stream().mapToDouble(PlannedCamera::price).sum();
  }

  /**
   * A point of the curve of coverage.
   *
   * @param cameras number of new cameras
   * @param price of these cameras, as the goal counts it
   * @param share of the demand that they meet
   * @param bound no cameras at this price meet a greater share
   */
  public record CurvePoint(int cameras, double price, double share, double bound) {}

  /** The share of the demand over the number of new cameras; those that add most come first. */
  public List<CurvePoint> curve() {
    int kept = problem.kept().size();
    int[] counts = problem.keptCounts().clone();
    List<Integer> rest = new ArrayList<>(IntStream.range(kept, planned.size()).boxed().toList());
    List<CurvePoint> curve = new ArrayList<>();
    DoubleUnaryOperator boundAtPrice = problem.shareBound(coverPlan);
    double price = 0;
    curve.add(new CurvePoint(0, 0, share(counts), share(counts)));
    while (!rest.isEmpty()) {
      Integer next = rest.get(0);
      for (Integer camera : rest) {
        next = worthWith(counts, camera) > worthWith(counts, next) ? camera : next;
      }
      rest.remove(next);
      count(counts, next);
      price += problem.countedPrice(planned.get(next).price);
      boolean isWholePlan = rest.isEmpty() && !problem.goal().isFullCover();
      double bound = isWholePlan ? shares.bound : boundAtPrice.applyAsDouble(price);
      double leastBound = shares.unrefined.isPresent() ? 0 : share(counts);
      int number = planned.size() - kept - rest.size();
      curve.add(new CurvePoint(number, price, share(counts), Math.max(leastBound, bound)));
    }
    return curve;
  }

  private double worthWith(int[] counts, int camera) {
    int[] countsWith = counts.clone();
    count(countsWith, camera);
    return problem.instance().worth(countsWith);
  }

  /** Returns the site with these cameras, and without the events of its old ones. */
  public Scenario scenario() {
    Scenario site = demand().site();
    List<ScenarioEvent> targetEvents =
        site.events().stream()
            .filter(
                event ->
                    event instanceof ScenarioEvent.AddTarget
                        || event instanceof ScenarioEvent.RemoveTarget)
            .toList();
    return floorplanInFolder(site)
        .with(Scenario.CAMERAS, cameras())
        .with(Scenario.EVENTS, targetEvents)
        .without(Scenario.VISION_GRAPH)
        .with(Scenario.NAME, site.name() + "-plan");
  }

  /** Returns the site with its floor plan in the folder of the plan. */
  private static Scenario floorplanInFolder(Scenario site) {
    return site.floorplan()
        .map(floor -> site.withFloorplan(new Floorplan(fileName(floor), floor.area())))
        .orElse(site);
  }

  private static String fileName(Floorplan floor) {
    return Path.of(floor.file()).getFileName().toString();
  }

  /** The height at which a camera hangs, metres; NaN if the site has none. */
  public double height(CameraSpec camera) {
    return camera.z().orElse(demand().site().mountHeight().orElse(Double.NaN));
  }

  /** Returns the site with all candidates as cameras, named by their kinds, and one target. */
  public Scenario candidateScenario() {
    List<CameraSpec> cameras = new ArrayList<>();
    for (Candidates.Candidate candidate : problem.candidates().list()) {
      cameras.add(candidate.camera(candidate.kind().name() + "/" + cameras.size()));
    }
    Scenario site = scenario();
    TargetSpec usual = UsualTarget.of(site);
    DemandPoint first = demand().points().get(0);
    return site.with(Scenario.CAMERAS, cameras)
        .with(Scenario.EVENTS, List.of())
        .with(Scenario.TARGETS, List.of(Demand.targetAt(first.x(), first.y(), 0, usual)));
  }

  /** Returns the connected parts of zones that no camera covers, the largest first. */
  public List<BlindSpot> blindSpots() {
    return BlindSpot.of(demand(), counts());
  }
}
