package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.SitePlan.Shares;
import org.hificamsim.solver.cover.CheaperPlan;
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.CoverPlan;
import org.hificamsim.solver.cover.CoverSearch;
import org.hificamsim.solver.cover.CurveBounds;
import org.hificamsim.solver.cover.Effort;
import org.hificamsim.solver.cover.Goal;

/**
 * The problem of where to mount cameras on a site, as a covering problem.
 *
 * @param instance the covering problem of the whole demand, as if no camera were kept; the one that
 *     is searched is {@link #remaining}
 * @param keptCounts for each point, the number of kept cameras that cover it
 */
public record PlacementProblem(
    Request request,
    Candidates candidates,
    PointSight sight,
    CoverInstance instance,
    int[] keptCounts) {

  /**
   * The request for a plan.
   *
   * @param options what can be mounted where
   * @param kept the cameras that stay
   * @param goal the goal of the new cameras
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

  /** Receives the progress of the search for a plan. */
  @FunctionalInterface
  public interface Watcher extends CoverSearch.Watcher {
    /** Receives the next part of the work, such as "measures what the plan meets". */
    default void begins(String part) {}
  }

  /**
   * Returns the problem of a site.
   *
   * @throws InputException if a zone is seen from no point, or the budget pays no camera
   */
  public static PlacementProblem of(Request request, Catalogue catalogue, Candidates.Work looking) {
    requireAffordable(request);
    PointSight sight = new PointSight(request.demand, catalogue);
    Candidates candidates = Candidates.of(request.options, request.reading, sight, looking);
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
        throw problem.unseen(zone, catalogue, looking.threads());
      }
    }
    return problem;
  }

  private InputException unseen(ZoneDemand zone, Catalogue catalogue, int threads) {
    if (isCutShort()) {
      return InputException.of(
          "zone '%s' is seen from none of the %s places from which cameras could look in this"
              + " time, of %s; expected more %s, or fewer %s",
          zone.name(),
          candidates.places(),
          request.options.points().size(),
          setting("time"),
          setting("candidates"));
    }
    return InputException.of(
        "zone '%s' is seen from none of %s places: %s; expected other %s, such as the ceiling,"
            + " lenses or demands",
        zone.name(),
        candidates.places(),
        reasonUnseen(zone, catalogue, threads),
        setting("candidates"));
  }

  /** Whether the time ended before cameras looked from all mount points. */
  boolean isCutShort() {
    return candidates.places() < request.options.points().size();
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
    Demand changed = new Demand(site, List.of(), demand().zones(), demand().points());
    PointSight changedSight = new PointSight(changed, catalogue);
    Candidates changedCandidates =
        Candidates.of(
            request.options,
            request.reading,
            changedSight,
            new Candidates.Work(threads, () -> false, () -> {}));
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

  /** Returns a price as the goal counts it: 1 if the goal is a number of cameras. */
  double countedPrice(double price) {
    return request.goal.byNumber ? 1 : price;
  }

  /**
   * Returns the covering problem that remains for new cameras; for full cover, it is limited to
   * what the candidates can cover.
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
   * Returns bounds on the shares that candidates can meet for some prices.
   *
   * @param searched the problem of the candidates that are not dominated
   * @param prices some prices, rising
   * @param shares the shares that are met for these prices, rising
   */
  double[] shareBounds(CoverPlan plan, CoverInstance searched, double[] prices, double[] shares) {
    double[] worths =
        Arrays.stream(shares).map(share -> share * instance.totalWorth() - keptWorth()).toArray();
    // the multipliers of full cover are prices
    double[] multipliers =
        goal().isFullCover() ? searched.unitWorths() : plan.multiplierBound().multipliers();
    double[] bounds = new CurveBounds(searched, multipliers).bounds(prices, worths);
    return Arrays.stream(bounds)
        .map(worth -> Math.min(1, (keptWorth() + worth) / instance.totalWorth()))
        .toArray();
  }

  /**
   * Searches for a plan, and then refines its cameras if that is wanted. Bounds hold for plans of
   * candidates; a refined plan may exceed them.
   */
  public SitePlan solve(Effort effort, Watcher watcher, Optional<Refinement> refinement) {
    CoverInstance remaining = remaining();
    int[] numbers = remaining.undominatedCandidates();
    CoverInstance searched = remaining.with(numbers);
    watcher.begins(
        Texts.format(
            "searches among %d candidates that others do not make superfluous, of %d",
            numbers.length, remaining.candidates()));
    CoverPlan found =
        CoverSearch.solveUndominated(
                searched,
                goal(),
                effort,
                (score, bound) -> watcher.improved(shownScore(score), shownScore(bound)))
            .withNumbers(numbers);
    watcher.begins("searches a plan that costs less");
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
    watcher.begins("measures what the plan meets");
    PlanCover cover = PlanCover.of(demand(), sight, plannedCameras(refined), request.reading);
    return new SitePlan(this, searched, cover, plan, shares);
  }

  /** Returns a plan that meets as much as another one for the lowest price that is found. */
  private CoverPlan cheaper(CoverPlan found, CoverInstance remaining, Effort effort) {
    CoverInstance priced =
        new CoverInstance(
            remaining.unitWorths(), remaining.needs(), remaining.covered(), candidates.prices());
    double maxCameras = request.goal.byNumber ? goal().budget() : Double.POSITIVE_INFINITY;
    int[] chosen = CheaperPlan.find(priced, found.chosen(), maxCameras, effort);
    return found.replacedBy(chosen, remaining.worth(remaining.counts(chosen)));
  }

  /** Returns the share that the present cameras of the site meet: of its area, or of points. */
  private double shareOfSite() {
    List<CameraSpec> cameras = demand().site().cameras();
    return demand().isForArea()
        ? PlanArea.of(demand(), sight, cameras, request.reading).share()
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

  /** Returns a score as it is shown: as a share of the demand; for full cover, as a price. */
  private double shownScore(double score) {
    return goal().isFullCover() ? score : (keptWorth() + score) / instance.totalWorth();
  }
}
