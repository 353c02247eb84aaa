package org.hificamsim.placement.site;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.view.Planner;
import org.hificamsim.solver.cover.Effort;
import org.hificamsim.solver.cover.Goal;

/**
 * Searches in a short time for a plan of cameras with fixed views, while a user waits for it.
 *
 * @param points where cameras can be mounted
 */
record QuickPlan(Catalogue catalogue, Demand demand, List<Point> points, Planner.Request request) {
  private static final int MAX_CAMERAS = 1000;

  /** The number of rounds without a better plan after which the search ends. */
  private static final int ROUNDS = 20;

  private static final double MAX_LOOKING_SECONDS = 30;
  private static final double MAX_SEARCH_SECONDS = 30;

  /** The share of the work that is done when all candidates are known. */
  private static final double SHARE_OF_CANDIDATES = 0.6;

  private static final double SHARE_WHILE_SEARCHING = 0.8;

  /**
   * Searches for the plan.
   *
   * @throws InputException if a zone is seen from nowhere, or the search is stopped too early
   */
  Planner.Plan find(List<CameraKind> kinds, Planner.Watcher watcher) {
    Scenario site = demand.site();
    PlacementProblem.Request problemRequest =
        new PlacementProblem.Request(
            demand,
            new Candidates.Options(points, kinds),
            CoverageReading.FIXED,
            request.keep() ? site.cameras() : List.of(),
            new PlacementProblem.SiteGoal(goal(), request.goal() == Planner.Goal.CAMERAS));
    AtomicInteger places = new AtomicInteger();
    int threads = Runtime.getRuntime().availableProcessors();
    PlacementProblem problem =
        PlacementProblem.of(
            problemRequest,
            catalogue,
            new Candidates.Work(
                threads,
                isOver(MAX_LOOKING_SECONDS),
                () -> reportPlaces(places.incrementAndGet(), watcher)));
    BooleanSupplier searched = isOver(MAX_SEARCH_SECONDS);
    Effort effort =
        Effort.searchOnly(0, ROUNDS, () -> watcher.isStopped() || searched.getAsBoolean());
    SitePlan plan =
        problem.solve(effort, (score, bound) -> improved(score, bound, watcher), Optional.empty());
    List<String> facts = plan.facts();
    return new Planner.Plan(plan.cameras(), facts.get(0), facts.subList(1, facts.size()));
  }

  /** Returns a condition that becomes true when some seconds have passed. */
  private static BooleanSupplier isOver(double seconds) {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    return () -> System.nanoTime() > end;
  }

  private Goal goal() {
    return switch (request.goal()) {
      case CAMERAS -> new Goal((int) Ranges.within("cameras", request.amount(), 1, MAX_CAMERAS));
      case BUDGET -> new Goal(Ranges.within("budget", request.amount(), 1, 1e9));
      case COVER -> Goal.FULL_COVER;
    };
  }

  private void reportPlaces(int places, Planner.Watcher watcher) {
    if (watcher.isStopped()) {
      throw new InputException("stopped before there was a plan");
    }
    watcher.progressed(
        Texts.format("looked from %d of %d places", places, points.size()),
        SHARE_OF_CANDIDATES * places / points.size());
  }

  private void improved(double score, double bound, Planner.Watcher watcher) {
    String found =
        request.goal() == Planner.Goal.COVER
            ? Texts.format("price %.0f, at least %.0f", score, bound)
            : Texts.format("%.1f %% met, at most %.1f %%", 100 * score, 100 * Math.min(1, bound));
    watcher.progressed("searches: " + found, SHARE_WHILE_SEARCHING);
  }
}
