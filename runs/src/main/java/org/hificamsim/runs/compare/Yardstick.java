package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Spelling;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.ScoredRun;

/**
 * A policy with which all policies of the same scenario, detection and seed are compared, and which
 * is run in addition for this purpose. If there are several, the first in this order is the main
 * one.
 */
@SuppressWarnings("ImmutableEnumChecker") // functions
public enum Yardstick {
  /** The exact optimum of each step. */
  OPTIMAL("the optimum", "of the optimum", ScoredRun::optimum, Metric.PROPORTION_OF_OPTIMAL),
  /** A bound that no configuration of a step exceeds, and perhaps none reaches. */
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
      Metric.VALUE_OF_LEARNING),
  /**
   * The most that cameras whose moves take time could have scored: the score that a plan reached,
   * and a bound, with which scores are compared.
   */
  REACHABLE(
      "what cameras could reach in time",
      "of what was reachable, at least",
      run -> run.reachable().atMost(),
      Metric.PROPORTION_OF_REACHABLE);

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

  /** The main yardstick of cases; empty if they have none. */
  public static Optional<Yardstick> of(List<CaseResult> cases) {
    return Arrays.stream(values()).filter(yardstick -> yardstick.isIn(cases)).findFirst();
  }

  /** Whether a policy is a yardstick, as opposed to a policy that cameras could run. */
  static boolean isYardstick(String policy) {
    return Arrays.stream(values()).anyMatch(yardstick -> yardstick.isRunBy(policy));
  }

  /** The metric by which the policies of some cases are compared. */
  static Metric metric(List<CaseResult> cases) {
    return of(cases).map(Yardstick::share).orElse(Metric.SCORE);
  }

  /** Whether some of the cases have this yardstick. */
  boolean isIn(List<CaseResult> cases) {
    return cases.stream().anyMatch(result -> !Double.isNaN(score(result.runs().get(0))));
  }

  /** The name of the policy that is run. */
  public String policy() {
    return Spelling.of(this);
  }

  /** Whether this yardstick runs a policy, given with its options. */
  boolean isRunBy(String policyText) {
    return policyText.equals(policy())
        || (this == REACHABLE && policyText.startsWith(policy() + ":"));
  }

  /** The name within a sentence. */
  public String noun() {
    return noun;
  }

  /** The title of a column with shares of this yardstick. */
  public String title() {
    return title;
  }

  /** Whether the score is a bound, and not that of a configuration. */
  public boolean isBound() {
    return this == BOUND || this == REACHABLE;
  }

  /** The score of the yardstick next to a run; NaN if it was not run. */
  double score(ScoredRun run) {
    return score.applyAsDouble(run);
  }

  /** The metric that divides a run's score by that of the yardstick. */
  public Metric share() {
    return share;
  }
}
