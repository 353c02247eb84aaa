package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.placement.cover.CoverPlan;

/**
 * Cameras for a site, and how good they are.
 *
 * @param cameras those that stay, then the new ones
 * @param prices of each; 0 for those that stay
 * @param covered by camera: the samples that it covers
 * @param plan what the search found: candidates among those of {@code problem}
 * @param unrefined the share of the demand that {@code plan} meets, in [0, 1], where cameras were
 *     moved since
 * @param bound the most of the demand that any plan of these candidates can meet, in [0, 1]
 * @param today what the cameras of the site as it is meet, in [0, 1]
 */
public record SitePlan(
    PlacementProblem problem,
    List<CameraSpec> cameras,
    List<Double> prices,
    int[][] covered,
    CoverPlan plan,
    Optional<Double> unrefined,
    double bound,
    double today) {

  /** What was asked. */
  public Demand demand() {
    return problem.demand();
  }

  /** How many cameras cover each sample. */
  public int[] counts() {
    return countsWithout(-1);
  }

  /** The same after the failure of one. */
  public int[] countsWithout(int failed) {
    int[] counts = new int[demand().samples().size()];
    for (int camera = 0; camera < covered.length; camera++) {
      for (int sample : camera == failed ? new int[0] : covered[camera]) {
        counts[sample]++;
      }
    }
    return counts;
  }

  /** The share of the demand that is met where samples are covered by this many cameras. */
  public double share(int[] counts) {
    return problem.whole().worth(counts) / problem.whole().total();
  }

  /** The share of the demand that is met. */
  public double share() {
    return share(counts());
  }

  /** How good it is, in lines for people: what is met first. */
  public List<String> facts() {
    String refined =
        "; refined from a plan of candidates that meets %.2f %%, a gain of %.2f points";
    List<String> facts = new ArrayList<>();
    facts.add(
        Texts.format(
            "%s, %d of them kept, price %.2f: %.2f %% of the demand is met",
            Texts.counted(cameras.size(), "camera"),
            problem.kept().size(),
            price(),
            100 * share()));
    facts.add(
        problem.reading().words()
            + unrefined
                .map(one -> Texts.format(refined, 100 * one, 100 * (share() - one)))
                .orElse(""));
    if (problem.goal().isAll()) {
      facts.add(
          Texts.format(
              "no plan costs less than %.2f: gap %.2f %%", plan.bound(), 100 * plan.gap()));
      facts.add(Texts.format("all candidates together meet %.2f %%", 100 * bound));
    } else {
      facts.add(Texts.format("no plan of these candidates meets more than %.2f %%", 100 * bound));
      facts.add(Texts.format("gap %.2f %%", 100 * (1 - unrefined.orElse(share()) / bound)));
    }
    if (plan.isProven()) {
      facts.add("proven: no plan of these candidates is better");
    }
    facts.add(
        Texts.format(
            "the site's own cameras (%d) meet %.2f %%",
            demand().site().cameras().size(), 100 * today));
    return facts;
  }

  /** What all new cameras cost. */
  public double price() {
    return prices.stream().mapToDouble(Double::doubleValue).sum();
  }

  /** A point of the curve: how much is met by the first cameras, and could be at their price. */
  public record Reached(int cameras, double price, double share, double bound) {}

  /** The share over the number of new cameras, those that add most first. */
  public List<Reached> curve() {
    int kept = problem.kept().size();
    int[] counts = new int[demand().samples().size()];
    IntStream.range(0, kept).forEach(camera -> add(counts, camera));
    List<Integer> left = new ArrayList<>(IntStream.range(kept, cameras.size()).boxed().toList());
    List<Reached> curve = new ArrayList<>();
    DoubleUnaryOperator most = problem.most(plan);
    double price = 0;
    curve.add(new Reached(0, 0, share(counts), share(counts)));
    while (!left.isEmpty()) {
      Integer next = left.get(0);
      for (Integer one : left) {
        next = worthWith(counts, one) > worthWith(counts, next) ? one : next;
      }
      left.remove(next);
      add(counts, next);
      price += problem.asked(prices.get(next));
      int number = cameras.size() - kept - left.size();
      double bound =
          left.isEmpty() && !problem.goal().isAll() ? this.bound : most.applyAsDouble(price);
      double least = unrefined.isPresent() ? 0 : share(counts);
      curve.add(new Reached(number, price, share(counts), Math.max(least, bound)));
    }
    return curve;
  }

  private void add(int[] counts, int camera) {
    for (int sample : covered[camera]) {
      counts[sample]++;
    }
  }

  private double worthWith(int[] counts, int camera) {
    int[] with = counts.clone();
    add(with, camera);
    return problem.whole().worth(with);
  }

  /** The site under these cameras: it runs. What happened to the cameras before happens no more. */
  public Scenario scenario() {
    Scenario site = demand().site();
    List<ScenarioEvent> events =
        site.events().stream()
            .filter(
                event ->
                    event instanceof ScenarioEvent.AddTarget
                        || event instanceof ScenarioEvent.RemoveTarget)
            .toList();
    return site.with(Scenario.CAMERAS, cameras)
        .with(Scenario.EVENTS, events)
        .without(Scenario.VISION_GRAPH)
        .with(Scenario.NAME, site.name() + "-plan");
  }

  /** The site under all candidates, named by their kinds, and a target. */
  public Scenario candidates() {
    List<CameraSpec> all = new ArrayList<>();
    for (Candidates.Candidate one : problem.candidates().all()) {
      all.add(one.camera(one.kind().name() + "/" + all.size()));
    }
    Scenario site = scenario();
    TargetSpec usual = Demand.usualTarget(site.everyTarget().toList());
    Demand.Sample first = demand().samples().get(0);
    return site.with(Scenario.CAMERAS, all)
        .with(Scenario.EVENTS, List.of())
        .with(Scenario.TARGETS, List.of(Demand.target(usual, 0, first.x(), first.y())));
  }

  /** The connected parts of zones that no camera covers, the largest first. */
  public List<BlindSpot> blindSpots() {
    return BlindSpot.of(demand(), counts());
  }
}
