package org.hificamsim.runs.compare;

import static org.hificamsim.runs.Metric.REACHABLE_BOUND;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;

/**
 * Runs plans, each repeat as a task of its own, and compares the score of each run with the
 * yardsticks of the same scenario, detection model and seed.
 *
 * <p>The results do not depend on the engine or its threads: a run depends only on its plan and
 * seed, and sums over runs are sums of whole numbers or are added in the order of seeds.
 */
public final class Comparison {
  private Comparison() {}

  /**
   * Runs all plans.
   *
   * @param requested the plans, all with the same seeds
   * @param references the yardsticks that are run in addition
   * @param engine the engine that computes the runs, already configured
   * @return the result of each requested plan, then those of the optima that were added
   */
  public static List<CaseResult> run(
      List<RunPlan> requested, ReferencePolicies references, RunEngine engine) throws IOException {
    List<RunPlan> plans = references.with(requested);
    List<CaseUnderWay> cases = plans.stream().map(CaseUnderWay::new).toList();
    engine.run(plans, tasks(plans), (task, run) -> cases.get(task.plan()).take(task.repeat(), run));
    return score(cases).subList(0, references.withOptimum(requested).size());
  }

  /** Returns every run, seed by seed, so that all cases advance together. */
  private static List<RunTask> tasks(List<RunPlan> plans) {
    List<RunTask> tasks = new ArrayList<>();
    for (int repeat = 0; repeat < plans.get(0).repeats(); repeat++) {
      for (int plan = 0; plan < plans.size(); plan++) {
        tasks.add(new RunTask(plan, repeat));
      }
    }
    return tasks;
  }

  private static List<CaseResult> score(List<CaseUnderWay> cases) {
    Map<ReferencePolicies.Group, List<CaseUnderWay>> groups =
        cases.stream().collect(Collectors.groupingBy(CaseUnderWay::group));
    return cases.stream().map(underWay -> underWay.scored(groups.get(underWay.group()))).toList();
  }

  /** A case whose repeats are being run by several threads. */
  private static final class CaseUnderWay {
    private final RunPlan plan;
    private final RunResult[] results;
    private final double[] settling;
    private final double[][] partMeans;

    /** k_min by step, summed over the runs: whole numbers, so that their order does not matter. */
    private final double[] kMinSums;

    /** Scores by step, summed over the runs in the order of seeds; {@link #kMinSums} if equal. */
    private final double[] scoreSums;

    /** Runs by repeat that have to wait until those of earlier seeds are added. */
    private final Map<Integer, FinishedRun> waiting = new HashMap<>();

    /** The number of runs in {@link #scoreSums}, and so the repeat that is added next. */
    private int added;

    CaseUnderWay(RunPlan plan) {
      this.plan = plan;
      this.results = new RunResult[plan.repeats()];
      this.settling = new double[plan.repeats()];
      this.partMeans = new double[plan.repeats()][];
      this.kMinSums = new double[plan.steps()];
      this.scoreSums = plan.objective().hasOwnFigure() ? new double[plan.steps()] : kMinSums;
    }

    synchronized void take(int repeat, FinishedRun run) {
      for (int step = 0; step < kMinSums.length; step++) {
        kMinSums[step] += run.kMin()[step];
      }
      settling[repeat] = run.settling();
      partMeans[repeat] = run.partMeans();
      results[repeat] = run.result().asRun(repeat);
      if (scoreSums != kMinSums) {
        waiting.put(repeat, run);
        for (FinishedRun next; (next = waiting.remove(added)) != null; added++) {
          add(next);
        }
      }
    }

    private void add(FinishedRun run) {
      for (int step = 0; step < scoreSums.length; step++) {
        scoreSums[step] += run.score(step);
      }
    }

    ReferencePolicies.Group group() {
      return ReferencePolicies.Group.of(plan);
    }

    /** The result, compared with the yardsticks among the cases of its group. */
    CaseResult scored(List<CaseUnderWay> group) {
      List<ScoredRun> runs = new ArrayList<>();
      for (int repeat = 0; repeat < results.length; repeat++) {
        runs.add(
            new ScoredRun(
                results[repeat],
                yardstickScore(group, Yardstick.OPTIMAL, repeat, RunResult::score),
                yardstickScore(group, Yardstick.BOUND, repeat, RunResult::bound),
                yardstickScore(group, Yardstick.BEST_FIXED, repeat, RunResult::score),
                new ScoredRun.Interval(
                    yardstickScore(group, Yardstick.REACHABLE, repeat, RunResult::score),
                    yardstickScore(
                        group, Yardstick.REACHABLE, repeat, run -> run.value(REACHABLE_BOUND))),
                settling[repeat]));
      }
      double[] meanKMin = means(kMinSums, runs.size());
      double[] meanScore = scoreSums == kMinSums ? meanKMin : means(scoreSums, runs.size());
      return new CaseResult(plan, runs, meanKMin, meanScore, partMeans);
    }

    private static double[] means(double[] sums, int count) {
      return Arrays.stream(sums).map(sum -> sum / count).toArray();
    }

    private static double yardstickScore(
        List<CaseUnderWay> group,
        Yardstick yardstick,
        int repeat,
        ToDoubleFunction<RunResult> score) {
      return group.stream()
          .filter(other -> yardstick.isRunBy(other.plan.policy()))
          .mapToDouble(other -> score.applyAsDouble(other.results[repeat]))
          .findFirst()
          .orElse(Double.NaN);
    }
  }
}
