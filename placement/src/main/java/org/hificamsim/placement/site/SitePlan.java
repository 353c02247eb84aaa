package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.runs.cells.UsualTarget;
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.CoverPlan;

/**
 * A plan that a search has found for a site, and how good it is.
 *
 * @param searched the covering problem that was searched: what new cameras have to cover, and the
 *     candidates that others do not make superfluous
 * @param cover what the cameras cover: those that stay, then the new ones
 * @param coverPlan the candidates of {@code problem} that the search chose, before any refinement
 */
public record SitePlan(
    PlacementProblem problem,
    CoverInstance searched,
    PlanCover cover,
    CoverPlan coverPlan,
    Shares shares)
    implements CameraPlan {
  /** The least gap that does not show as 0. */
  private static final double LEAST_SHOWN_GAP = 0.00005;

  /**
   * Shares of the demand, in [0, 1].
   *
   * @param unrefined the share that {@code coverPlan} meets, if its cameras were refined
   * @param bound the share that no plan of the same candidates exceeds
   * @param ofSite the share that the cameras of the site meet as it is
   */
  public record Shares(Optional<Double> unrefined, double bound, double ofSite) {}

  @Override
  public CoverageReading reading() {
    return problem.request().reading();
  }

  @Override
  public int keptCameras() {
    return problem.kept().size();
  }

  /** The kinds of the new cameras, at their prices; refining a plan changes none of them. */
  @Override
  public List<Product> products() {
    return Arrays.stream(coverPlan.chosen())
        .mapToObj(problem.candidates().list()::get)
        .map(Candidate::kind)
        .map(kind -> new Product(kind.name(), kind.price()))
        .toList();
  }

  @Override
  public List<String> facts() {
    List<String> facts = new ArrayList<>();
    facts.add(claim(keptFact(), Texts.format("%.2f", price())));
    if (demand().isForArea()) {
      facts.add(
          Texts.format(
              "measured on the area; the search and its bound are of samples, of which %.2f %% is"
                  + " met",
              100 * cover.share()));
    }
    facts.add(reading().words() + refinementFact());
    if (problem.goal().isFullCover()) {
      facts.add(
          Texts.format("no plan costs less than %.2f", coverPlan.bound())
              + gapFact(coverPlan.gap()));
      facts.add(Texts.format("all candidates together meet %.2f %%", 100 * shares.bound));
    } else {
      double found = shares.unrefined.orElse(cover.share());
      facts.add(
          Texts.format("no plan of these candidates meets more than %.2f %%", 100 * shares.bound)
              + gapFact(1 - found / shares.bound));
    }
    provenOf().ifPresent(these -> facts.add("proven of " + these + ": no plan of these is better"));
    if (problem.isCutShort()) {
      facts.add(
          Texts.format(
              "in this time cameras looked from %d of %d places, all over the site",
              problem.candidates().places(), problem.request().options().points().size()));
    }
    int before = demand().site().cameras().size();
    if (before > 0) {
      facts.add(
          Texts.format(
              "%s of the scenario as it was: %.2f %% is met",
              Texts.counted(before, "camera"), 100 * shares.ofSite));
    }
    return facts;
  }

  /**
   * Returns in words for which samples and candidates no plan is better; the proof does not hold
   * for the area or for other places. Empty if it is not proven.
   */
  public Optional<String> provenOf() {
    if (!coverPlan.isProven()) {
      return Optional.empty();
    }
    return Optional.of(
        Texts.format(
            "%s and %s at %s%s",
            Texts.counted(demand().points().size(), "sample"),
            Texts.counted(problem.candidates().list().size(), "candidate"),
            Texts.counted(problem.candidates().places(), "place"),
            shares.unrefined.isEmpty() ? "" : ", before refinement"));
  }

  private String keptFact() {
    int kept = problem.kept().size();
    return kept == 0 ? "" : Texts.format(", %d of them kept (in all %.2f)", kept, cover.price());
  }

  /** Returns words on the distance of the plan from its bound; empty if it reaches the bound. */
  private static String gapFact(double gap) {
    return gap < LEAST_SHOWN_GAP ? "" : Texts.format(": a gap of %.2f %%", 100 * gap);
  }

  private String refinementFact() {
    if (shares.unrefined.isEmpty()) {
      return "";
    }
    double before = shares.unrefined.get();
    return Texts.format(
        "; refined from a plan of candidates that meets %.2f %%, a gain of %.2f points",
        100 * before, 100 * (cover.share() - before));
  }

  /**
   * A point of the curve of coverage.
   *
   * @param cameras the number of new cameras
   * @param price the price of these cameras, as the goal counts it
   * @param share the share of the demand that they meet
   * @param bound the share that no cameras at this price exceed
   */
  public record CurvePoint(int cameras, double price, double share, double bound) {}

  /**
   * Returns the share of the demand that is met for each number of new cameras, the ones that add
   * most first.
   */
  public List<CurvePoint> curve() {
    int kept = keptCameras();
    int[] counts = problem.keptCounts().clone();
    List<Integer> rest = new ArrayList<>(IntStream.range(kept, cameras().size()).boxed().toList());
    double[] prices = new double[rest.size()];
    double[] met = new double[rest.size()];
    double keptShare = cover.share(counts);
    double price = 0;
    for (int number = 0; number < prices.length; number++) {
      Integer next = rest.get(0);
      for (Integer camera : rest) {
        next = worthWith(counts, camera) > worthWith(counts, next) ? camera : next;
      }
      rest.remove(next);
      count(counts, next);
      price += problem.countedPrice(cameras().get(next).price());
      prices[number] = price;
      met[number] = cover.share(counts);
    }
    double[] bounds = bounds(prices, met);
    List<CurvePoint> curve = new ArrayList<>();
    curve.add(new CurvePoint(0, 0, keptShare, keptShare));
    for (int number = 0; number < prices.length; number++) {
      curve.add(new CurvePoint(number + 1, prices[number], met[number], bounds[number]));
    }
    return curve;
  }

  private double[] bounds(double[] prices, double[] met) {
    double[] bounds = problem.shareBounds(coverPlan, searched, prices, met);
    for (int number = 0; number < bounds.length; number++) {
      boolean isWholePlan = number == bounds.length - 1 && !problem.goal().isFullCover();
      double bound = isWholePlan ? shares.bound : Math.min(shares.bound, bounds[number]);
      double leastBound = shares.unrefined.isPresent() ? 0 : met[number]; // but for rounding
      bounds[number] = Math.max(leastBound, bound);
    }
    return bounds;
  }

  private void count(int[] counts, int camera) {
    for (int point : cover.covered()[camera]) {
      counts[point]++;
    }
  }

  private double worthWith(int[] counts, int camera) {
    int[] countsWith = counts.clone();
    count(countsWith, camera);
    return problem.instance().worth(countsWith);
  }

  /** Returns the site with these cameras, and without the events of its old ones. */
  @Override
  public Scenario scenario() {
    Scenario site = demand().site();
    List<ScenarioEvent> targetEvents =
        site.events().stream()
            .filter(
                event ->
                    event instanceof ScenarioEvent.AddTarget
                        || event instanceof ScenarioEvent.RemoveTarget)
            .toList();
    return CameraPlan.withFloorplanInFolder(site)
        .with(Scenario.CAMERAS, cameras())
        .with(Scenario.EVENTS, targetEvents)
        .without(Scenario.VISION_GRAPH)
        .with(Scenario.NAME, site.name() + "-plan");
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
}
