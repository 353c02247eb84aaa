package org.hificamsim.runs;

import java.io.Serializable;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;

/**
 * The result of one repeat.
 *
 * @param values the values of the metrics that the run has on its own
 * @param gap the most that the score could gain in the steps whose configuration is not proven to
 *     be the best
 * @param zoneShares for each zone's name, the share of the zone that is seen as it demands, the
 *     mean over the steps; empty if the result was read from a table
 */
public record RunResult(
    int run, long seed, EnumMap<Metric, Double> values, double gap, Map<String, Double> zoneShares)
    implements Serializable {
  /** The result of a repeat. */
  public static RunResult of(int run, long seed, Measured measured) {
    double gap = measured.proof().map(Proof::gap).orElse(0.0);
    Map<String, Double> zones = measured.zones().shares();
    return new RunResult(run, seed, Metric.measure(measured), gap, zones);
  }

  /** A result with known values of a policy that does not claim to be the best. */
  public static RunResult of(int run, long seed, Map<Metric, Double> values) {
    return new RunResult(run, seed, new EnumMap<>(values), 0, Map.of());
  }

  /** Whether the run has a metric. */
  public boolean has(Metric metric) {
    return values.containsKey(metric);
  }

  /** The value of a metric; NaN if the run does not have it. */
  public double value(Metric metric) {
    return values.getOrDefault(metric, Double.NaN);
  }

  /** The mean of one metric over the repeats of a plan. */
  public static Estimate mean(RunPlan plan, List<RunResult> results, Metric metric) {
    return metric.mean(plan, results.stream().mapToDouble(run -> run.value(metric)).toArray());
  }

  /**
   * Returns the share of each zone that is seen as the zone demands, mean over repeats, by name.
   */
  public static Map<String, Double> zoneShares(List<RunResult> results) {
    Map<String, Double> means = new LinkedHashMap<>();
    for (String zone : results.get(0).zoneShares.keySet()) {
      means.put(
          zone,
          results.stream().mapToDouble(run -> run.zoneShares.get(zone)).average().orElseThrow());
    }
    return means;
  }

  /** The sum of the steps' scores by the objective; the performance by default. */
  public double score() {
    return value(Metric.SCORE);
  }

  /** The most that the score could have been; NaN if the policy does not claim to be the best. */
  public double bound() {
    return has(Metric.UNPROVEN_STEPS) ? score() + gap : Double.NaN;
  }

  /** The proof of the policy; empty if it does not claim to be the best. */
  public Optional<Proof> proof() {
    return has(Metric.UNPROVEN_STEPS)
        ? Optional.of(new Proof((long) value(Metric.UNPROVEN_STEPS), gap))
        : Optional.empty();
  }

  /**
   * The most by which the mean of the steps' least expected coverage could have been higher; 0 if
   * it is proven to be the best, or the policy does not claim that.
   */
  private double expectedGap() {
    double gain = value(Metric.LEAST_EXPECTED_K_BOUND) - value(Metric.LEAST_EXPECTED_K);
    return gain > 0 ? gain : 0; // 0 for NaN
  }

  /**
   * The steps in which the claim to be the best is not proven, in words; empty if there are none.
   */
  public static Optional<String> unprovenSteps(RunPlan plan, List<RunResult> results) {
    Proof proof =
        results.stream()
            .flatMap(result -> result.proof().stream())
            .reduce(Proof.NO_STEPS, Proof::plus);
    return proof.unprovenSteps() > 0
        ? Optional.of(proof.describeUnproven(plan.work(), plan.objective()))
        : Optional.empty();
  }

  /** The amount by which the least expected k could be higher, in words; empty if it is proven. */
  public static Optional<String> unprovenExpectation(List<RunResult> results) {
    double gap = results.stream().mapToDouble(RunResult::expectedGap).max().orElse(0);
    return gap > 0
        ? Optional.of(
            Texts.format("the least expected k of a step might be up to %.3g higher", gap))
        : Optional.empty();
  }

  /** The same result with another number: plans may reach the same seed in different repeats. */
  public RunResult asRun(int repeat) {
    return new RunResult(repeat, seed, values, gap, zoneShares);
  }
}
