package org.hificamsim.runs.compare;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/**
 * A finished run with the k_min and the score of each step.
 *
 * @param scores the scores of the steps; empty if the score is k_min
 */
public record FinishedRun(RunResult result, int[] kMin, double[] scores) implements Serializable {
  private static final int MAX_PARTS = 50;

  /** The share of the final level from which a run counts as settled. */
  private static final double SETTLED = 0.9;

  /** Computes one repeat of a plan. */
  public static FinishedRun of(RunExecutor executor, RunPlan plan, int repeat) {
    int[] kMin = new int[plan.steps()];
    double[] scores = new double[plan.objective().hasOwnFigure() ? plan.steps() : 0];
    StepListener listener =
        (network, coverage) -> {
          int step = (int) network.step();
          kMin[step] = coverage.kMin();
          if (scores.length > 0) {
            scores[step] = coverage.score();
          }
        };
    return new FinishedRun(executor.repeat(plan, repeat, List.of(listener)), kMin, scores);
  }

  /** The score of a step. */
  double score(int step) {
    return scores.length == 0 ? kMin[step] : scores[step];
  }

  /** The mean score in each of fifty equal parts; in each step if the run has fewer steps. */
  double[] partMeans() {
    int parts = Math.min(MAX_PARTS, kMin.length);
    double[] means = new double[parts];
    for (int part = 0; part < parts; part++) {
      int from = start(part, parts, kMin.length);
      int to = start(part + 1, parts, kMin.length);
      for (int step = from; step < to; step++) {
        means[part] += score(step) / (to - from);
      }
    }
    return means;
  }

  /** The step at which a part begins; for {@code part == parts}, the number of steps. */
  public static int start(int part, int parts, int steps) {
    return (int) ((long) part * steps / parts);
  }

  /**
   * The first step, from 0, at which the run has reached its final level: the mean k_min of the
   * window of 5% of the run that begins there is at least 90% of the mean over the last tenth of
   * the run. NaN if that mean is 0.
   */
  double settling() {
    int tail = Math.max(1, kMin.length / 10);
    int window = Math.max(1, kMin.length / 20);
    double level = SETTLED * sum(kMin.length - tail, kMin.length) / tail * window;
    if (level == 0) {
      return Double.NaN;
    }
    long inWindow = sum(0, window);
    for (int start = 0; start + window < kMin.length; start++) {
      if (inWindow >= level) {
        return start;
      }
      inWindow += kMin[start + window] - kMin[start];
    }
    return kMin.length - window;
  }

  private long sum(int from, int to) {
    return Arrays.stream(kMin, from, to).asLongStream().sum();
  }
}
