package org.hificamsim.reproduction.ladder;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.reproduction.ladder.Ladder.RungScenario;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;

/**
 * What a step costs on this machine, with all that a run measures of it: the least of some timed
 * runs in one thread, each so short that other programs seldom come between.
 */
final class StepCost {
  private static final long MIN_NANOSECONDS = 2_000_000;
  private static final int ROUNDS = 25;
  private static final int FIRST_STEPS = 16;
  private static final int MAX_STEPS = 1 << 24;

  private final RunExecutor executor;
  private final String policy;

  StepCost(RunExecutor executor, String policy) {
    this.executor = executor;
    this.policy = policy;
  }

  /** Nanoseconds a step, for each; taken in turns, so that all meet the same load. */
  List<Double> of(List<RungScenario> places) {
    List<RunPlan> plans = places.stream().map(this::calibrated).toList();
    double[] least = plans.stream().mapToDouble(this::nanoseconds).toArray();
    for (int round = 1; round < ROUNDS; round++) {
      for (int i = 0; i < least.length; i++) {
        least[i] = Math.min(least[i], nanoseconds(plans.get(i)));
      }
    }
    return Arrays.stream(least).boxed().toList();
  }

  /** A plan with enough steps for the clock; it is warm then. */
  private RunPlan calibrated(RungScenario place) {
    RunPlan plan = plan(place, FIRST_STEPS);
    while (isShort(plan) && plan.steps() < MAX_STEPS) {
      plan = plan(place, 2 * plan.steps());
    }
    return plan;
  }

  private RunPlan plan(RungScenario place, int steps) {
    return place.plan(policy, Settings.NONE.with(Setting.STEPS, Integer.toString(steps)));
  }

  /** Whether any of three runs is: one alone may have been interrupted. */
  private boolean isShort(RunPlan plan) {
    return IntStream.range(0, 3)
        .anyMatch(any -> nanoseconds(plan) * plan.steps() < MIN_NANOSECONDS);
  }

  private double nanoseconds(RunPlan plan) {
    long start = System.nanoTime();
    executor.repeat(plan, 0, List.of());
    return (double) (System.nanoTime() - start) / plan.steps();
  }
}
