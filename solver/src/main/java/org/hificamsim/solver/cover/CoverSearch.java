package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.Comparator;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.hificamsim.solver.Exchange;

/**
 * Finds a plan, and a bound on all plans of the same candidates.
 *
 * <ol>
 *   <li>Dominated candidates are omitted.
 *   <li>Two greedy plans, by gain and by gain per price, are made; the better one is at least half
 *       of 1 - 1/e of the best, together with the best single candidate (Khuller, Moss and Naor
 *       1999), which an exchange finds.
 *   <li>Single candidates are exchanged as long as the plan improves.
 *   <li>Rounds follow in which {@link LagrangianBound} is improved, and a part of the best plan is
 *       removed and filled again.
 *   <li>If asked for, an {@link ExactMethod} closes the gap.
 * </ol>
 */
public final class CoverSearch implements Exchange.Choice {
  /** Receives the score and the bound when one of them has improved. */
  @FunctionalInterface
  public interface Watcher {
    /** Receives the present score and bound. */
    void improved(double score, double bound);
  }

  private static final int BOUND_STEPS_PER_ROUND = 40;

  /** The least share of its price that a candidate keeps when the bound makes it cheaper. */
  private static final double MIN_PRICE_SHARE = 1e-3;

  private static final double PRICE_NOISE = 0.1;
  private static final int KERNEL_CANDIDATES = 1000;

  /** The gap, as a share of the score, above which linear bounds are of little use. */
  private static final double LOOSE_GAP = 0.03;

  /** The share of the best worth below which a refilled plan is not improved by exchanges. */
  private static final double MIN_EXCHANGED_SHARE = 0.97;

  private static final double MARGIN = 1e-9;

  private final CoverInstance instance;
  private final Goal goal;
  private final SplittableRandom random;
  private final BooleanSupplier stop;

  /** The plan that is being changed. */
  private final Selection selection;

  /** The candidates that are exchanged, one after the other. */
  private int[] exchanged = {};

  /** The best plan so far, in ascending order; only {@link #keep} replaces it. */
  private int[] best = {};

  /** The score of the best plan. */
  private double score;

  private CoverSearch(CoverInstance instance, Goal goal, Effort effort) {
    this.instance = instance;
    this.goal = goal;
    this.random = new SplittableRandom(effort.seed());
    this.stop = effort::searchEnds;
    this.selection = new Selection(instance);
    this.score = goal.isFullCover() ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
  }

  /**
   * Searches for a plan.
   *
   * @param instance the instance; for full cover it has to be {@link CoverInstance#coverable}
   */
  public static CoverPlan solve(CoverInstance instance, Goal goal, Effort effort, Watcher watcher) {
    int[] undominated = instance.undominatedCandidates();
    CoverPlan plan = solveUndominated(instance.with(undominated), goal, effort, watcher);
    return plan.withNumbers(undominated);
  }

  /**
   * Searches for a plan.
   *
   * @param instance the instance, without dominated candidates; for full cover it has to be {@link
   *     CoverInstance#coverable}
   */
  public static CoverPlan solveUndominated(
      CoverInstance instance, Goal goal, Effort effort, Watcher watcher) {
    long started = System.nanoTime();
    CoverSearch search = new CoverSearch(instance, goal, effort);
    search.makeFirstPlan();
    LagrangianBound lagrangian = LagrangianBound.of(instance, goal, instance.counts(search.best));
    watcher.improved(search.score, lagrangian.bound());
    search.improve(effort.idleRounds(), lagrangian, watcher);
    double bound = lagrangian.bound();
    if (effort.exact().isPresent() && !lagrangian.proves(search.score)) {
      bound = search.closeGap(lagrangian, effort, watcher);
    }
    return new CoverPlan(
        search.best,
        search.score,
        bound,
        new CoverPlan.MultiplierBound(lagrangian.bound(), lagrangian.bestMultipliers()),
        (System.nanoTime() - started) / 1e9);
  }

  /**
   * Continues exactly with the candidates that a better plan may contain. If there are many, the
   * candidates that the bound finds most promising come first, to find a better plan (kernel
   * search: Angelelli, Mansini and Speranza 2010).
   *
   * @return the new bound
   */
  private double closeGap(LagrangianBound lagrangian, Effort effort, Watcher watcher) {
    double before = lagrangian.bound();
    int[] open = lagrangian.openCandidates(score, best);
    if (open.length > 2 * KERNEL_CANDIDATES) {
      int[] kernel = lagrangian.cheapestCandidates(KERNEL_CANDIDATES, best);
      solveExactly(kernel, before, effort, effort.limits().kernel());
      watcher.improved(score, before);
      open = lagrangian.openCandidates(score, best);
    }
    double exactBound = solveExactly(open, before, effort, effort.limits().exact());
    double bound = goal.tightened(exactBound, goal.scoreStep(instance));
    watcher.improved(score, bound);
    boolean scoreIsBetter = goal.isBetter(score, bound);
    if (scoreIsBetter && Math.abs(bound - score) > 1e-6 * Math.max(1, Math.abs(score))) {
      throw new IllegalStateException("a plan scores " + score + " beyond its bound " + bound);
    }
    return scoreIsBetter ? score : bound; // the score can be better by rounding only
  }

  /**
   * Solves the problem of some candidates, and returns their bound. If the gap is wide and the
   * problem suits it, {@link Enumeration} replaces the method that the user asks for.
   *
   * @param candidates the candidates, in ascending order, among them those of the best plan
   * @param bound the bound that is known already
   */
  private double solveExactly(int[] candidates, double bound, Effort effort, BooleanSupplier end) {
    int[] start =
        Arrays.stream(best).map(candidate -> Arrays.binarySearch(candidates, candidate)).toArray();
    CoverInstance part = instance.with(candidates);
    boolean loose = Math.abs(bound - score) > LOOSE_GAP * Math.abs(score);
    ExactMethod method =
        loose && Enumeration.suits(part, goal) ? new Enumeration() : effort.exact().orElseThrow();
    ExactMethod.Result result = method.solve(part, goal, start, bound, end);
    keep(Arrays.stream(result.chosen()).map(number -> candidates[number]).toArray());
    return result.bound();
  }

  private void makeFirstPlan() {
    new Greedy(instance, goal, selection, candidate -> 1).fill();
    keepSelectionIfBest();
    selection.set(new int[0]);
    new Greedy(instance, goal, selection, candidate -> instance.prices()[candidate]).fill();
    keepSelectionIfBest();
    selection.set(best);
    exchange();
  }

  private void improve(int maxIdleRounds, LagrangianBound lagrangian, Watcher watcher) {
    int idleRounds = 0;
    while (idleRounds < maxIdleRounds && !stop.getAsBoolean() && !lagrangian.proves(score)) {
      double before = lagrangian.bound();
      if (!lagrangian.isExhausted()) {
        lagrangian.improve(BOUND_STEPS_PER_ROUND, score, stop);
      }
      boolean better = refillBest(lagrangian);
      idleRounds = better || !lagrangian.isExhausted() ? 0 : idleRounds + 1;
      if (better || lagrangian.bound() != before) {
        watcher.improved(score, lagrangian.bound());
      }
    }
  }

  /** Removes a random part of the best plan and fills it again; returns whether it improved. */
  private boolean refillBest(LagrangianBound lagrangian) {
    selection.set(best);
    int removals = 1 + random.nextInt(Math.max(1, best.length / 2));
    for (int i = 0; i < removals && best.length > 0; i++) {
      int candidate = best[random.nextInt(best.length)];
      if (selection.has(candidate)) {
        selection.remove(candidate);
      }
    }
    double[] weights = instance.prices().clone();
    for (int candidate = 0; goal.isFullCover() && candidate < weights.length; candidate++) {
      double least = MIN_PRICE_SHARE * weights[candidate];
      double price = Math.max(least, lagrangian.reducedPrice(candidate));
      weights[candidate] = price * (1 + PRICE_NOISE * random.nextDouble());
    }
    new Greedy(instance, goal, selection, candidate -> weights[candidate]).fill();
    double before = score;
    keepSelectionIfBest();
    boolean promising = selection.worth() > MIN_EXCHANGED_SHARE * score;
    if (!goal.isFullCover() && score == before && promising) {
      exchange();
    }
    return score != before;
  }

  /**
   * Keeps the selected plan if it is the best; for full cover, redundant candidates are removed
   * first, beginning with the most expensive.
   */
  private void keepSelectionIfBest() {
    if (goal.isFullCover()) {
      IntStream.of(selection.candidates())
          .boxed()
          .sorted(Comparator.comparingDouble(candidate -> -instance.prices()[candidate]))
          .forEachOrdered(this::removeIfRedundant);
    }
    keep(selection.candidates());
  }

  private void removeIfRedundant(int candidate) {
    if (selection.isRedundant(candidate)) {
      selection.remove(candidate);
    }
  }

  /** Makes a plan the best one, if the goal allows it and it is better. */
  private void keep(int[] candidates) {
    double newScore = goal.score(instance, candidates);
    boolean better =
        goal.isFullCover()
            ? newScore < score - MARGIN
            : newScore > score + MARGIN * Math.abs(score);
    boolean allowed =
        goal.isFullCover()
            ? instance.isFullyCovered(instance.counts(candidates))
            : goal.affords(instance.price(candidates));
    if (allowed && (better || best.length == 0)) {
      best = candidates;
      score = newScore;
    }
  }

  /** Replaces one candidate after the other by a better one until the plan improves no more. */
  private void exchange() {
    if (!goal.isFullCover()) {
      Exchange.improve(this, Exchange.UNLIMITED);
    }
    keep(selection.candidates());
  }

  @Override
  public int choosers() {
    exchanged = stop.getAsBoolean() ? new int[0] : selection.candidates();
    return exchanged.length;
  }

  @Override
  public boolean exchange(int chooser) {
    int candidate = exchanged[chooser];
    double before = selection.worth();
    selection.remove(candidate);
    int replacement = candidate;
    double greatestGain = selection.gain(candidate) * (1 + MARGIN);
    for (int other = 0; other < instance.candidates(); other++) {
      double price = selection.price() + instance.prices()[other];
      boolean possible = !selection.has(other) && goal.affords(price);
      double gain = possible ? selection.gain(other) : 0;
      if (gain > greatestGain) {
        greatestGain = gain;
        replacement = other;
      }
    }
    selection.add(replacement);
    return replacement != candidate && selection.worth() > before;
  }
}
