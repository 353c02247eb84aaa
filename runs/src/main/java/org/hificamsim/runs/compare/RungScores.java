package org.hificamsim.runs.compare;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoredRun;

/**
 * The mean scores of a step of policies in one scenario under one rung, or under one detection of a
 * comparison. If detections happen by chance, the score of k_min is the expected k_min, so that
 * knowing the luck is no advantage.
 *
 * @param score the mean score by policy, then by seed
 * @param optimum the mean score of the exact optimum by seed; if detections happen by chance, the
 *     optimum knows the luck
 */
public record RungScores(double[][] score, double[] optimum) {
  /** Returns the scores of policies, given cases of one scenario and detection. */
  public static RungScores of(List<CaseResult> cases) {
    return new RungScores(
        cases.stream().map(RungScores::score).toArray(double[][]::new),
        cases.get(0).runs().stream()
            .mapToDouble(run -> run.optimum() / cases.get(0).plan().steps())
            .toArray());
  }

  private static double[] score(CaseResult result) {
    return result.runs().stream().mapToDouble(run -> score(result.plan(), run)).toArray();
  }

  private static double score(RunPlan plan, ScoredRun run) {
    return plan.objective().hasOwnFigure() ? run.result().score() / plan.steps() : kMin(plan, run);
  }

  private static double kMin(RunPlan plan, ScoredRun run) {
    return plan.detection().certain()
        ? run.result().value(Metric.MEAN_K_MIN)
        : run.result().value(Metric.EXPECTED_PERFORMANCE) / plan.steps();
  }

  /** The number of seeds. */
  public int seeds() {
    return optimum.length;
  }

  /** The mean of each policy over some seeds, given by their numbers, which may repeat. */
  public double[] means(int[] seeds) {
    return Arrays.stream(score).mapToDouble(bySeed -> mean(bySeed, seeds)).toArray();
  }

  /** The mean of each policy over all seeds. */
  public double[] means() {
    return means(allSeeds());
  }

  private int[] allSeeds() {
    return IntStream.range(0, seeds()).toArray();
  }

  /** The policies with the best mean over all seeds; several if they tie. */
  public int[] best() {
    return best(allSeeds());
  }

  /** The policies with the best mean over some seeds. */
  public int[] best(int[] seeds) {
    double[] means = means(seeds);
    double best = Arrays.stream(means).max().orElseThrow();
    return IntStream.range(0, means.length).filter(policy -> means[policy] == best).toArray();
  }

  /** The rank of each policy, 1 for the best; policies that tie share the better rank. */
  public int[] ranks() {
    double[] means = means();
    return Arrays.stream(means)
        .mapToInt(mean -> 1 + (int) Arrays.stream(means).filter(other -> other > mean).count())
        .toArray();
  }

  /** The mean over some policies and seeds: the expected score of a random one of them. */
  public double mean(int[] policies, int[] seeds) {
    return Arrays.stream(policies)
        .mapToDouble(policy -> mean(score[policy], seeds))
        .average()
        .orElseThrow();
  }

  /** The mean over some policies for each seed. */
  double[] bySeed(int[] policies) {
    return IntStream.range(0, seeds())
        .mapToDouble(seed -> mean(policies, new int[] {seed}))
        .toArray();
  }

  /** The mean of the optimum over some seeds. */
  public double optimum(int[] seeds) {
    return mean(optimum, seeds);
  }

  private static double mean(double[] values, int[] seeds) {
    return Arrays.stream(seeds).mapToDouble(seed -> values[seed]).average().orElseThrow();
  }
}
