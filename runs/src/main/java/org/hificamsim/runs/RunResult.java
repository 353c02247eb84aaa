package org.hificamsim.runs;

import java.io.Serializable;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;

/**
 * What one repeat measured.
 *
 * @param values of the metrics that the run has on its own
 * @param gap what the score might gain at most in the steps whose configuration is not proven to be
 *     the best
 */
public record RunResult(int run, long seed, EnumMap<Metric, Double> values, double gap)
    implements Serializable {
  /** The result of a repeat. */
  public static RunResult of(int run, long seed, Measured measured) {
    double gap = measured.proof().map(Proof::gap).orElse(0.0);
    return new RunResult(run, seed, Metric.measure(measured), gap);
  }

  /** A result of known values, of a policy that claims nothing. */
  public static RunResult of(int run, long seed, Map<Metric, Double> values) {
    return new RunResult(run, seed, new EnumMap<>(values), 0);
  }

  /** Whether the run has a metric. */
  public boolean has(Metric metric) {
    return values.containsKey(metric);
  }

  /** A metric's value; NaN where the run does not have it. */
  public double value(Metric metric) {
    return values.getOrDefault(metric, Double.NaN);
  }

  /** The mean of one metric over repeats. */
  public static Estimate mean(List<RunResult> results, Metric metric) {
    return Estimate.mean(results.stream().mapToDouble(result -> result.value(metric)).toArray());
  }

  /** The sum of the steps' scores by the objective; the performance by default. */
  public double score() {
    return value(Metric.SCORE);
  }

  /** What the score could have been at most; NaN under a policy that claims nothing. */
  public double bound() {
    return has(Metric.UNPROVEN_STEPS) ? score() + gap : Double.NaN;
  }

  /** What the policy proved; empty under one that does not claim to be the best. */
  public Optional<Proof> proof() {
    return has(Metric.UNPROVEN_STEPS)
        ? Optional.of(new Proof((long) value(Metric.UNPROVEN_STEPS), gap))
        : Optional.empty();
  }

  /**
   * What the least expected coverage of a step might have been higher at most, in the mean; 0 where
   * that is proven to be the best, or where the policy does not claim it.
   */
  private double expectedGap() {
    double more = value(Metric.LEAST_EXPECTED_K_BOUND) - value(Metric.LEAST_EXPECTED_K);
    return more > 0 ? more : 0;
  }

  /** In how many steps of a plan's repeats a policy's claim to be the best is not proven. */
  public static Optional<String> unprovenSteps(RunPlan plan, List<RunResult> results) {
    Proof proof =
        results.stream()
            .flatMap(result -> result.proof().stream())
            .reduce(Proof.OF_NOTHING, Proof::plus);
    return proof.unprovenSteps() > 0
        ? Optional.of(proof.missing(plan.work(), plan.objective()))
        : Optional.empty();
  }

  /** How much higher the least expected k might be, where the best one is not proven. */
  public static Optional<String> unprovenExpectation(List<RunResult> results) {
    double gap = results.stream().mapToDouble(RunResult::expectedGap).max().orElse(0);
    return gap > 0
        ? Optional.of(
            Texts.format("the least expected k of a step might be up to %.3g higher", gap))
        : Optional.empty();
  }

  /** The same result as another repeat: a run with this seed may be any repeat of a plan. */
  public RunResult asRun(int repeat) {
    return new RunResult(repeat, seed, values, gap);
  }
}
