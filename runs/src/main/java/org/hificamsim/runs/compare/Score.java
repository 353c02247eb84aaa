package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Proof;

/**
 * A figure of a scored run: what a run measures on its own, and what needs the optimum beside it.
 *
 * @param label the name in files
 */
public record Score(String label, ToDoubleFunction<ScoredRun> figure) {
  public static final Score PERFORMANCE = of(Metric.PERFORMANCE);
  public static final Score SCORE = of(Metric.SCORE);
  public static final Score PROPORTION_OF_OPTIMAL =
      new Score("proportion_of_optimal", ScoredRun::proportionOfOptimal);

  public static final Score OVER_BEST_FIXED =
      new Score("value_of_learning", ScoredRun::overBestFixed);

  /** Every figure, in the order of files. */
  public static final List<Score> ALL = all();

  /** Figures of the policies that claim to be the best, beside all others. */
  static List<Score> ofProofs(Objective objective) {
    return List.of(
        new Score("unproven_steps", run -> proof(run).unprovenSteps()),
        new Score(Proof.boundLabel(objective), run -> proof(run).bound(run.result().score())));
  }

  /** Figures of the optimum, where the best fixed configuration was run too. */
  static final List<Score> OF_ADAPTING =
      List.of(
          new Score("best_fixed", run -> run.bestFixed().orElseThrow()),
          new Score("value_of_adapting", ScoredRun::overBestFixed));

  /** The figure of one run. */
  public double of(ScoredRun run) {
    return figure.applyAsDouble(run);
  }

  /** A metric as a score. */
  public static Score of(Metric metric) {
    return new Score(metric.label(), run -> metric.of(run.result()));
  }

  private static Proof proof(ScoredRun run) {
    return run.result().proof().orElseThrow();
  }

  private static List<Score> all() {
    List<Score> all = new ArrayList<>();
    all.add(PERFORMANCE);
    all.add(PROPORTION_OF_OPTIMAL);
    all.add(new Score("regret", ScoredRun::regret));
    for (Metric metric : Metric.values()) {
      if (metric != Metric.PERFORMANCE && !metric.ofChance()) {
        all.add(of(metric));
      }
    }
    all.add(new Score("settling_steps", ScoredRun::settling));
    return List.copyOf(all);
  }
}
