package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Spelling;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.ScoredRun;

/**
 * What all scores of a scenario, detection and seed are measured by: a policy that is run in
 * addition to those asked for. Where there are several, the first here leads.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Yardstick {
  /** The exact optimum of each step. */
  OPTIMAL("the optimum", "of the optimum", ScoredRun::optimum, Metric.PROPORTION_OF_OPTIMAL),
  /** What no configuration of a step exceeds; perhaps none reaches it. */
  BOUND(
      "a bound on the optimum",
      "of the optimum, at least",
      ScoredRun::bound,
      Metric.PROPORTION_OF_BOUND),
  /** The best configuration that never changes. */
  BEST_FIXED(
      "the best fixed configuration",
      "over best-fixed",
      ScoredRun::bestFixed,
      Metric.VALUE_OF_LEARNING);

  private final String noun;
  private final String title;
  private final ToDoubleFunction<ScoredRun> score;
  private final Metric share;

  Yardstick(String noun, String title, ToDoubleFunction<ScoredRun> score, Metric share) {
    this.noun = noun;
    this.title = title;
    this.score = score;
    this.share = share;
  }

  /** What leads in some cases; empty where only what was asked for was run. */
  public static Optional<Yardstick> of(List<CaseResult> cases) {
    return Arrays.stream(values()).filter(one -> one.isIn(cases)).findFirst();
  }

  /** Whether a policy is one of them, and none that a network could choose. */
  static boolean isOne(String policy) {
    return Arrays.stream(values()).anyMatch(one -> one.policy().equals(policy));
  }

  /** The metric by which the policies of some cases are compared. */
  static Metric metric(List<CaseResult> cases) {
    return of(cases).map(Yardstick::share).orElse(Metric.SCORE);
  }

  /** Whether some of the cases are measured by it. */
  boolean isIn(List<CaseResult> cases) {
    return cases.stream().anyMatch(one -> !Double.isNaN(score(one.runs().get(0))));
  }

  /** Its name: that of the policy which is run. */
  public String policy() {
    return Spelling.of(this);
  }

  /** What it is, within a sentence. */
  public String noun() {
    return noun;
  }

  /** What a share of it is called in tables. */
  public String title() {
    return title;
  }

  /** Whether it is a bound on what is possible, and not what a configuration reached. */
  public boolean isBound() {
    return this == BOUND;
  }

  /** What it came to with a run; NaN where it was not run. */
  double score(ScoredRun run) {
    return score.applyAsDouble(run);
  }

  /** A run's score over what it came to. */
  public Metric share() {
    return share;
  }
}
