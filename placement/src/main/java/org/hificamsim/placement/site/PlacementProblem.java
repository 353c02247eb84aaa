package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.Duals;
import org.hificamsim.placement.cover.Effort;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.site.Candidates.Candidate;

/**
 * Where to put cameras on a site, as a covering problem.
 *
 * @param kept cameras that stay
 * @param goal what is asked of the new cameras; their price is their number where {@code byNumber}
 * @param whole all that is demanded, by candidate
 * @param keptCounts how many of those that stay cover each sample
 */
public record PlacementProblem(
    Demand demand,
    Candidates candidates,
    CoverageReading reading,
    List<CameraSpec> kept,
    Goal goal,
    boolean byNumber,
    SampleSight sight,
    CoverInstance whole,
    int[] keptCounts) {

  /**
   * The problem of a site.
   *
   * @throws InputException where a zone is seen from no place, or no camera can be paid
   */
  public static PlacementProblem of(
      Demand demand,
      List<Point> places,
      List<CameraKind> kinds,
      CoverageReading reading,
      List<CameraSpec> kept,
      Goal goal,
      boolean byNumber,
      Catalogue catalogue,
      int threads) {
    double cheapest = kinds.stream().mapToDouble(CameraKind::price).min().orElseThrow();
    if (!byNumber && cheapest > goal.budget()) {
      throw InputException.of(
          "%s is %s, expected at least %s, the price of the cheapest camera",
          setting("budget"), goal.budget(), cheapest);
    }
    SampleSight sight = new SampleSight(demand, catalogue);
    Candidates candidates = Candidates.of(places, kinds, reading, sight, threads);
    double[] prices = candidates.prices();
    if (byNumber) {
      Arrays.fill(prices, 1);
    }
    CoverInstance whole =
        new CoverInstance(demand.units(), demand.needs(), candidates.columns(), prices);
    int[] counts = new int[demand.samples().size()];
    for (int[] seen : sight.covered(kept, reading)) {
      for (int sample : seen) {
        counts[sample]++;
      }
    }
    PlacementProblem problem =
        new PlacementProblem(
            demand, candidates, reading, kept, goal, byNumber, sight, whole, counts);
    problem.requireSeen(places, kinds, catalogue, threads);
    return problem;
  }

  private void requireSeen(
      List<Point> places, List<CameraKind> kinds, Catalogue catalogue, int threads) {
    int[] can = whole.coverable().needs();
    for (Demand.Watched zone : demand.zones()) {
      boolean seen =
          IntStream.range(zone.first(), zone.end()).anyMatch(s -> can[s] + keptCounts[s] > 0);
      if (zone.count() > 0 && !seen) {
        Scenario open = demand.site().with(Scenario.OBSTACLES, List.of());
        Predicate<Scenario> sees =
            site -> {
              Demand same = new Demand(site, demand.cells(), demand.zones(), demand.samples());
              SampleSight other = new SampleSight(same, catalogue);
              return Arrays.stream(Candidates.of(places, kinds, reading, other, threads).columns())
                  .flatMapToInt(Arrays::stream)
                  .anyMatch(s -> s >= zone.first() && s < zone.end());
            };
        boolean walls = sees.test(open);
        boolean heights = demand.site().hasHeights() && !walls && sees.test(open.flat());
        throw InputException.of(
            "zone '%s' is seen from none of %s places: %s; expected other %s,"
                + " lenses or demands",
            zone.name(),
            places.size(),
            walls
                ? "walls are in between"
                : heights
                    ? "it is above or below all views"
                    : "it is too far for '%s' with these lenses".formatted(zone.detection().name()),
            setting("candidates"));
      }
    }
  }

  /** What a price counts for in the goal: each camera is one, where their number is asked. */
  double asked(double price) {
    return byNumber ? 1 : price;
  }

  /** What is left to the new cameras; where all is to be met, as far as candidates can. */
  public CoverInstance left() {
    CoverInstance left = whole.after(keptCounts);
    return goal.isAll() ? left.coverable() : left;
  }

  private double base() {
    return whole.worth(keptCounts);
  }

  /** By price: the most of the demand that candidates can meet, by the multipliers of a plan. */
  DoubleUnaryOperator most(CoverPlan plan) {
    CoverInstance left = whole.after(keptCounts).undominated();
    double[] multipliers = goal.isAll() ? left.units() : plan.proof();
    return price ->
        Math.min(1, (base() + Duals.value(left, new Goal(price), multipliers)) / whole.total());
  }

  /** Searches for a plan, whose cameras may then be moved. */
  public SitePlan solve(Effort effort, CoverSearch.Watcher watcher, Optional<Refinement> moves) {
    CoverPlan plan =
        CoverSearch.solve(
            left(), goal, effort, (score, bound) -> watcher.improved(shown(score), shown(bound)));
    List<CameraSpec> cameras = new ArrayList<>(kept);
    List<Double> prices = new ArrayList<>();
    kept.forEach(any -> prices.add(0.0));
    int number = 1;
    List<Candidate> chosen = Arrays.stream(plan.chosen()).mapToObj(candidates.all()::get).toList();
    for (Candidate one : moves.map(how -> how.of(this, chosen)).orElse(chosen)) {
      String name;
      do {
        name = "P" + number++;
      } while (isTaken(name));
      cameras.add(one.camera(name));
      prices.add(one.kind().price());
    }
    Scenario site = demand.site();
    int[] searched = whole.counts(plan.chosen());
    Arrays.setAll(searched, sample -> searched[sample] + keptCounts[sample]);
    int[] today = new int[keptCounts.length];
    for (int[] seen : sight.covered(site.cameras(), reading)) {
      Arrays.stream(seen).forEach(sample -> today[sample]++);
    }
    return new SitePlan(
        this,
        List.copyOf(cameras),
        prices,
        sight.covered(cameras, reading),
        plan,
        moves.map(how -> whole.worth(searched) / whole.total()),
        goal.isAll() ? coverable() : Math.min(1, shown(plan.bound())),
        whole.worth(today) / whole.total());
  }

  /** The share of the demand that all candidates together can meet. */
  private double coverable() {
    return (base() + whole.after(keptCounts).coverable().total()) / whole.total();
  }

  /** A score as it is shown: a share of the demand, or a price. */
  private double shown(double score) {
    return goal.isAll() ? score : (base() + score) / whole.total();
  }

  private boolean isTaken(String name) {
    return kept.stream().anyMatch(camera -> camera.name().equals(name));
  }
}
