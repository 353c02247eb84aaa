package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.cover.CheaperPlan;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.Effort;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.cover.LagrangianBound;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.SitePlan.Shares;

/**
 * Where to put cameras on a site, as a covering problem.
 *
 * @param instance the whole demand, as if no camera were kept; {@link #remaining} is searched
 * @param keptCounts by point, the number of kept cameras that cover it
 */
public record PlacementProblem(
    Request request,
    Candidates candidates,
    PointSight sight,
    CoverInstance instance,
    int[] keptCounts) {

  /** The parts that a plan's multipliers have in those that bound the shares of lower prices. */
  private static final List<Double> PARTS_OF_PLAN = List.of(0.0, 0.25, 0.5, 0.75, 1.0);

  /**
   * What is asked for.
   *
   * @param options what can be mounted where
   * @param kept cameras that stay
   * @param goal of the new cameras
   */
  public record Request(
      Demand demand,
      Candidates.Options options,
      CoverageReading reading,
      List<CameraSpec> kept,
      SiteGoal goal) {}

  /**
   * The goal of new cameras.
   *
   * @param byNumber whether each camera has a price of 1, so that the budget is their number
   */
  public record SiteGoal(Goal goal, boolean byNumber) {}

  /**
   * Returns the problem of a site.
   *
   * @param finished is told of each point whose candidates are known
   * @throws InputException if a zone is seen from no point, or the budget pays no camera
   */
  public static PlacementProblem of(
      Request request, Catalogue catalogue, int threads, Runnable finished) {
    requireAffordable(request);
    PointSight sight = new PointSight(request.demand, catalogue);
    Candidates candidates =
        Candidates.of(request.options, request.reading, sight, threads, finished);
    double[] prices = candidates.prices();
    if (request.goal.byNumber) {
      Arrays.fill(prices, 1);
    }
    CoverInstance instance =
        new CoverInstance(
            request.demand.unitWorths(), request.demand.needs(), candidates.covered(), prices);
    int[] keptCounts = counts(sight, request, request.kept);
    PlacementProblem problem =
        new PlacementProblem(request, candidates, sight, instance, keptCounts);
    int[] possibleNeeds = instance.coverable().needs();
    for (ZoneDemand zone : request.demand.zones()) {
      if (zone.count() > 0 && !problem.isCoverable(zone, possibleNeeds)) {
        throw InputException.of(
            "zone '%s' is seen from none of %s places: %s; expected other %s,"
                + " lenses or demands",
            zone.name(),
            request.options.points().size(),
            problem.reasonUnseen(zone, catalogue, threads),
            setting("candidates"));
      }
    }
    return problem;
  }

  private static void requireAffordable(Request request) {
    double budget = request.goal.goal.budget();
    double cheapest =
        request.options.kinds().stream().mapToDouble(CameraKind::price).min().orElseThrow();
    if (!request.goal.byNumber && cheapest > budget) {
      throw InputException.of(
          "%s is %s, expected at least %s, the price of the cheapest camera",
          setting("budget"), budget, cheapest);
    }
  }

  private static int[] counts(PointSight sight, Request request, List<CameraSpec> cameras) {
    int[] counts = new int[request.demand.points().size()];
    for (int[] covered : sight.covered(cameras, request.reading)) {
      for (int point : covered) {
        counts[point]++;
      }
    }
    return counts;
  }

  private boolean isCoverable(ZoneDemand zone, int[] possibleNeeds) {
    return IntStream.range(zone.first(), zone.end())
        .anyMatch(point -> possibleNeeds[point] + keptCounts[point] > 0);
  }

  private String reasonUnseen(ZoneDemand zone, Catalogue catalogue, int threads) {
    if (demand().place(zone).asksForFaces()) {
      return "it is too far, behind walls, or no face is seen as it asks";
    }
    Scenario withoutWalls = demand().site().with(Scenario.OBSTACLES, List.of());
    if (isSeen(zone, withoutWalls, catalogue, threads)) {
      return "walls are in between";
    }
    boolean hasHeights = demand().site().hasHeights();
    return hasHeights && isSeen(zone, withoutWalls.flat(), catalogue, threads)
        ? "it is above or below all views"
        : "it is too far for '%s' with these lenses".formatted(zone.detection().name());
  }

  /** Whether any candidate sees the zone on a changed site. */
  private boolean isSeen(ZoneDemand zone, Scenario site, Catalogue catalogue, int threads) {
    Demand changed = new Demand(site, demand().cells(), demand().zones(), demand().points());
    PointSight changedSight = new PointSight(changed, catalogue);
    Candidates changedCandidates =
        Candidates.of(request.options, request.reading, changedSight, threads, () -> {});
    return Arrays.stream(changedCandidates.covered())
        .flatMapToInt(Arrays::stream)
        .anyMatch(point -> point >= zone.first() && point < zone.end());
  }

  public Demand demand() {
    return request.demand;
  }

  /** The cameras that stay. */
  public List<CameraSpec> kept() {
    return request.kept;
  }

  public Goal goal() {
    return request.goal.goal;
  }

  /** The price as the goal counts it: 1 if the goal is a number of cameras. */
  double countedPrice(double price) {
    return request.goal.byNumber ? 1 : price;
  }

  /**
   * The cover that remains for new cameras; for full cover, as far as the candidates can give it.
   */
  public CoverInstance remaining() {
    CoverInstance remaining = instance.remaining(keptCounts);
    return goal().isFullCover() ? remaining.coverable() : remaining;
  }

  /** The share of the demand that is met if points are covered this often. */
  double share(int[] counts) {
    return instance.worth(counts) / instance.totalWorth();
  }

  private double keptWorth() {
    return instance.worth(keptCounts);
  }

  /**
   * Returns a bound on the share that candidates can meet, as a function of the budget. Any
   * multipliers prove one: those of a plan are tight at its own price, the unit worths at low
   * prices, and means of both in between. Those of full cover are prices and not worths, so that
   * the unit worths alone count there.
   */
  DoubleUnaryOperator shareBound(CoverPlan plan) {
    CoverInstance undominated = instance.remaining(keptCounts).undominated();
    double[] worths = undominated.unitWorths();
    double[] ofPlan = goal().isFullCover() ? worths : plan.multiplierBound().multipliers();
    List<double[]> multipliers =
        PARTS_OF_PLAN.stream().map(part -> mean(ofPlan, worths, part)).toList();
    return budget -> {
      double worth =
          multipliers.stream()
              .mapToDouble(proof -> LagrangianBound.value(undominated, new Goal(budget), proof))
              .min()
              .orElseThrow();
      return Math.min(1, (keptWorth() + worth) / instance.totalWorth());
    };
  }

  private static double[] mean(double[] values, double[] others, double part) {
    return IntStream.range(0, values.length)
        .mapToDouble(i -> part * values[i] + (1 - part) * others[i])
        .toArray();
  }

  /**
   * Searches for a plan, whose cameras may then be refined. Bounds are on plans of candidates; a
   * refined plan may exceed them.
   */
  public SitePlan solve(
      Effort effort, CoverSearch.Watcher watcher, Optional<Refinement> refinement) {
    CoverInstance remaining = remaining();
    CoverPlan found =
        CoverSearch.solve(
            remaining,
            goal(),
            effort,
            (score, bound) -> watcher.improved(shownScore(score), shownScore(bound)));
    CoverPlan plan = goal().isFullCover() ? found : cheaper(found, remaining, effort);
    List<Candidate> chosen = Arrays.stream(plan.chosen()).mapToObj(candidates.list()::get).toList();
    List<Candidate> refined =
        refinement.isPresent() ? refinement.get().refine(this, chosen) : chosen;
    int[] unrefinedCounts = instance.counts(plan.chosen());
    Arrays.setAll(unrefinedCounts, point -> unrefinedCounts[point] + keptCounts[point]);
    Shares shares =
        new Shares(
            refinement.isPresent() ? Optional.of(share(unrefinedCounts)) : Optional.empty(),
            goal().isFullCover() ? coverableShare() : Math.min(1, shownScore(plan.bound())),
            shareOfSite());
    PlanCover cover = PlanCover.of(demand(), sight, plannedCameras(refined), request.reading);
    return new SitePlan(this, cover, plan, shares);
  }

  /** Returns a plan that meets as much as another one for the lowest price that is found. */
  private CoverPlan cheaper(CoverPlan found, CoverInstance remaining, Effort effort) {
    CoverInstance priced =
        new CoverInstance(
            remaining.unitWorths(), remaining.needs(), remaining.covered(), candidates.prices());
    double maxCameras = request.goal.byNumber ? goal().budget() : Double.POSITIVE_INFINITY;
    int[] chosen = CheaperPlan.of(priced, found.chosen(), maxCameras, effort);
    return found.replacedBy(chosen, remaining.worth(remaining.counts(chosen)));
  }

  /** The share that the present cameras of the site meet: of the area, or of demand points. */
  private double shareOfSite() {
    List<CameraSpec> cameras = demand().site().cameras();
    return demand().isForArea()
        ? PlanArea.of(demand(), sight, cameras, request.reading).of(demand())
        : share(counts(sight, request, cameras));
  }

  private List<CameraSpec> plannedCameras(List<Candidate> newCandidates) {
    List<CameraSpec> cameras = new ArrayList<>(kept());
    int number = 1;
    for (Candidate candidate : newCandidates) {
      while (isTaken("P" + number)) {
        number++;
      }
      CameraSpec camera = candidate.camera("P" + number++);
      cameras.add(camera.with(CameraSpec.PRICE, candidate.kind().price()));
    }
    return cameras;
  }

  private boolean isTaken(String name) {
    return kept().stream().anyMatch(camera -> camera.name().equals(name));
  }

  /** The share of the demand that all candidates together can meet. */
  private double coverableShare() {
    double worth = instance.remaining(keptCounts).coverable().totalWorth();
    return (keptWorth() + worth) / instance.totalWorth();
  }

  /** A score as it is shown: a share of the demand; for full cover, a price. */
  private double shownScore(double score) {
    return goal().isFullCover() ? score : (keptWorth() + score) / instance.totalWorth();
  }
}
