package org.hificamsim.placement.cover;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Finds a plan and a bound: candidates that others dominate are left out; greedy by gains and by
 * gains for a price, the better one (Khuller, Moss and Naor 1999: at least half of 1 - 1/e of the
 * best, together with the best single candidate, which exchange finds); exchanges of one candidate
 * for another; and again from the best plan with some of it taken away. The bound is {@link Duals}.
 */
public final class CoverSearch {
  /** Receives a new best plan or bound. */
  @FunctionalInterface
  public interface Watcher {
    /** The score and the bound, now. */
    void improved(double score, double bound);
  }

  private static final int STEPS = 40; // of the bound, between two rounds
  private static final double LEAST = 1e-3; // of a price, that remains of it
  private static final double NOISE = 0.1;
  private static final int KERNEL = 1000; // candidates
  private static final double LOOSE = 0.03; // a bound that tells a linear solver little, as a share

  private final CoverInstance instance;
  private final Goal goal;
  private final SplittableRandom random;
  private final BooleanSupplier stop;
  private final Chosen plan;
  private int[] best = {};
  private double score;

  private CoverSearch(CoverInstance instance, Goal goal, long seed, BooleanSupplier stop) {
    this.instance = instance;
    this.goal = goal;
    this.random = new SplittableRandom(seed);
    this.stop = stop;
    this.plan = new Chosen(instance);
    this.score = goal.isAll() ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
  }

  /**
   * Searches.
   *
   * @param all what is asked where everything is to be seen has to be {@link
   *     CoverInstance#coverable}
   */
  public static CoverPlan solve(CoverInstance all, Goal goal, Effort effort, Watcher watcher) {
    long started = System.nanoTime();
    int[] left = Dominance.left(all);
    CoverInstance instance = all.with(left);
    CoverSearch search = new CoverSearch(instance, goal, effort.seed(), effort::isEnough);
    search.first();
    Duals duals = new Duals(instance, goal, instance.counts(search.best));
    watcher.improved(search.score, duals.bound());
    search.rounds(effort.rounds(), duals, watcher);
    double bound = duals.bound();
    if (effort.exact().isPresent() && !duals.isClosed(search.score)) {
      bound = search.close(duals, effort, watcher);
    }
    int[] chosen = Arrays.stream(search.best).map(one -> left[one]).toArray();
    double seconds = (System.nanoTime() - started) / 1e9;
    return new CoverPlan(chosen, search.score, bound, duals.bound(), duals.proof(), seconds);
  }

  /**
   * Goes on exactly with what the bound leaves; where that is much, with what the bound makes the
   * best of it first, to find a better plan (kernel search: Angelelli, Mansini and Speranza 2010).
   *
   * @return the new bound
   */
  private double close(Duals duals, Effort effort, Watcher watcher) {
    double before = duals.bound();
    int[] open = duals.open(score, best);
    if (open.length > 2 * KERNEL) {
      exactly(duals.kernel(KERNEL, best), before, effort, effort.most());
      watcher.improved(score, before);
      open = duals.open(score, best);
    }
    double bound =
        goal.tightened(exactly(open, before, effort, effort.stop()), goal.quantum(instance));
    watcher.improved(score, bound);
    boolean passed = goal.isAll() ? bound > score : bound < score;
    if (passed && Math.abs(bound - score) > 1e-6 * Math.max(1, Math.abs(score))) {
      throw new IllegalStateException("a plan scores " + score + " beyond its bound " + bound);
    }
    return passed ? score : bound; // by rounding
  }

  /** Solves for these candidates alone, which the best plan is among; returns the bound. */
  private double exactly(int[] open, double bound, Effort effort, BooleanSupplier enough) {
    int[] start = Arrays.stream(best).map(one -> Arrays.binarySearch(open, one)).toArray();
    CoverInstance some = instance.with(open);
    boolean loose = Math.abs(bound - score) > LOOSE * Math.abs(score);
    ExactMethod method =
        loose && Enumeration.suits(some, goal) ? new Enumeration() : effort.exact().orElseThrow();
    ExactMethod.Found found = method.solve(some, goal, start, bound, enough);
    keep(Arrays.stream(found.chosen()).map(one -> open[one]).toArray());
    return found.bound();
  }

  private void first() {
    Greedy.fill(plan, instance, goal, any -> 1);
    finish();
    plan.set(new int[0]);
    Greedy.fill(plan, instance, goal, one -> instance.prices()[one]);
    finish();
    plan.set(best);
    exchange();
  }

  private void rounds(int patience, Duals duals, Watcher watcher) {
    int idle = 0;
    while (idle < patience && !stop.getAsBoolean() && !duals.isClosed(score)) {
      double before = duals.bound();
      if (!duals.isSpent()) {
        duals.improve(STEPS, score, stop);
      }
      boolean better = again(duals);
      idle = better || !duals.isSpent() ? 0 : idle + 1;
      if (better || duals.bound() != before) {
        watcher.improved(score, duals.bound());
      }
    }
  }

  /** From the best plan with some of it taken away; returns whether it became better. */
  private boolean again(Duals duals) {
    plan.set(best);
    int away = 1 + random.nextInt(Math.max(1, best.length / 2));
    for (int i = 0; i < away && best.length > 0; i++) {
      int one = best[random.nextInt(best.length)];
      if (plan.has(one)) {
        plan.remove(one);
      }
    }
    double[] weights = instance.prices().clone();
    for (int one = 0; goal.isAll() && one < weights.length; one++) { // what the bound makes of them
      double price = Math.max(LEAST * weights[one], duals.reducedPrice(one));
      weights[one] = price * (1 + NOISE * random.nextDouble());
    }
    Greedy.fill(plan, instance, goal, one -> weights[one]);
    double before = score;
    finish();
    if (!goal.isAll() && score == before && plan.worth() > 0.97 * score) {
      exchange();
    }
    return score != before;
  }

  /** Leaves out what the plan does not need, the dearest first, and keeps it if it is the best. */
  private void finish() {
    IntStream.of(plan.candidates())
        .boxed()
        .sorted((one, other) -> Double.compare(instance.prices()[other], instance.prices()[one]))
        .filter(one -> goal.isAll() && plan.isRedundant(one)) // each when its turn comes
        .forEach(plan::remove);
    keep(plan.candidates());
  }

  private void keep(int[] candidates) {
    double found = goal.score(instance, candidates);
    boolean better = goal.isAll() ? found < score - 1e-9 : found > score + 1e-9 * Math.abs(score);
    boolean allowed = goal.isAll() ? isWhole(candidates) : goal.affords(instance.price(candidates));
    if (allowed && (better || best.length == 0)) {
      best = candidates;
      score = found;
    }
  }

  private boolean isWhole(int[] candidates) {
    int[] counts = instance.counts(candidates);
    return IntStream.range(0, counts.length).allMatch(s -> counts[s] >= instance.needs()[s]);
  }

  /** Puts another candidate in the place of one, while the plan becomes better. */
  private void exchange() {
    for (boolean better = !goal.isAll(); better && !stop.getAsBoolean(); ) {
      better = false;
      for (int out : plan.candidates()) {
        better |= exchange(out);
      }
    }
    keep(plan.candidates());
  }

  private boolean exchange(int out) {
    double before = plan.worth();
    plan.remove(out);
    int in = out;
    double most = plan.gain(out) * (1 + 1e-9);
    for (int j = 0; j < instance.candidates(); j++) {
      boolean possible = !plan.has(j) && goal.affords(plan.price() + instance.prices()[j]);
      double gain = possible ? plan.gain(j) : 0;
      if (gain > most) {
        most = gain;
        in = j;
      }
    }
    plan.add(in);
    return in != out && plan.worth() > before;
  }
}
