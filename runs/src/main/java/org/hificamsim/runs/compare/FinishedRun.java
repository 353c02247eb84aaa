package org.hificamsim.runs.compare;

import java.io.Serializable;
import java.util.List;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** A finished run with its k_min, step by step. */
public record FinishedRun(RunResult result, int[] kMin) implements Serializable {
  /** Computes one repeat of a plan. */
  public static FinishedRun of(RunExecutor executor, RunPlan plan, int repeat) {
    int[] kMin = new int[plan.steps()];
    return new FinishedRun(
        executor.repeat(
            plan,
            repeat,
            List.of((network, coverage) -> kMin[(int) network.step()] = coverage.kMin())),
        kMin);
  }
}
