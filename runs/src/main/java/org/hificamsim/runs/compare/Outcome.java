package org.hificamsim.runs.compare;

import java.io.Serializable;
import java.util.List;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** A finished run with its k_min, step by step. */
public record Outcome(RunResult result, int[] kMin) implements Serializable {
  /** Computes one repeat of a plan. */
  public static Outcome of(RunExecutor executor, RunPlan plan, int repeat) {
    int[] kMin = new int[plan.steps()];
    return new Outcome(
        executor.repeat(
            plan,
            repeat,
            List.of((network, coverage) -> kMin[(int) network.step()] = coverage.kMin())),
        kMin);
  }
}
