package org.hificamsim.runs.compare;

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
 * Runs plans side by side, every repeat a task of its own, and scores each run against the
 * yardsticks of its scenario, detection model and seed.
 *
 * <p>The results do not depend on the engine or its threads: a run depends on its plan and seed
 * alone, and sums over runs are sums of whole numbers, or added in the order of seeds.
 */
public final class Comparison {
  private Comparison() {}

  /**
   * Runs all plans.
   *
   * @param asked plans with the same seeds
   * @param references what is run in addition, to score all by
   * @param engine where the runs are computed, configured
   * @return one result per plan that was asked for, then those of the optima that had to be added
   */
  public static List<CaseResult> run(
      List<RunPlan> asked, ReferencePolicies references, RunEngine engine) throws IOException {
    List<RunPlan> plans = references.with(asked);
    List<CaseUnderWay> cases = plans.stream().map(CaseUnderWay::new).toList();
    engine.run(plans, tasks(plans), (task, run) -> cases.get(task.plan()).take(task.repeat(), run));
    return score(cases).subList(0, references.withOptimum(asked).size());
  }

  /** Every run, seed by seed, so that all cases make headway together. */
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
    return cases.stream().map(one -> one.scored(groups.get(one.group()))).toList();
  }

  /** A plan whose repeats are being run, by several threads. */
  private static final class CaseUnderWay {
    private final RunPlan plan;
    private final RunResult[] results;
    private final double[] settling;
    private final double[][] levels;
    private final double[] sums; // of whole numbers, exact; at the end the means
    private final double[] scores; // sums in the order of seeds; at the end the means
    private final Map<Integer, FinishedRun> waiting = new HashMap<>(); // for those before them
    private int added;

    CaseUnderWay(RunPlan plan) {
      this.plan = plan;
      this.results = new RunResult[plan.repeats()];
      this.settling = new double[plan.repeats()];
      this.levels = new double[plan.repeats()][];
      this.sums = new double[plan.steps()];
      this.scores = plan.objective().hasOwnFigure() ? new double[plan.steps()] : sums;
    }

    synchronized void take(int repeat, FinishedRun run) {
      for (int step = 0; step < sums.length; step++) {
        sums[step] += run.kMin()[step];
      }
      settling[repeat] = run.settling();
      levels[repeat] = run.levels();
      results[repeat] = run.result().asRun(repeat);
      if (scores != sums) {
        waiting.put(repeat, run);
        for (FinishedRun next; (next = waiting.remove(added)) != null; added++) {
          add(next);
        }
      }
    }

    private void add(FinishedRun run) {
      for (int step = 0; step < scores.length; step++) {
        scores[step] += run.score(step);
      }
    }

    ReferencePolicies.Group group() {
      return ReferencePolicies.Group.of(plan);
    }

    /** With the yardsticks that are among the cases of its group. */
    CaseResult scored(List<CaseUnderWay> group) {
      List<ScoredRun> runs = new ArrayList<>();
      for (int repeat = 0; repeat < results.length; repeat++) {
        runs.add(
            new ScoredRun(
                results[repeat],
                of(group, Yardstick.OPTIMAL, repeat, RunResult::score),
                of(group, Yardstick.BOUND, repeat, RunResult::bound),
                of(group, Yardstick.BEST_FIXED, repeat, RunResult::score),
                settling[repeat]));
      }
      Arrays.setAll(sums, step -> sums[step] / runs.size());
      if (scores != sums) {
        Arrays.setAll(scores, step -> scores[step] / runs.size());
      }
      return new CaseResult(plan, runs, sums, scores, levels);
    }

    private static double of(
        List<CaseUnderWay> group,
        Yardstick yardstick,
        int repeat,
        ToDoubleFunction<RunResult> figure) {
      return group.stream()
          .filter(one -> one.plan.policy().equals(yardstick.policy()))
          .mapToDouble(one -> figure.applyAsDouble(one.results[repeat]))
          .findFirst()
          .orElse(Double.NaN);
    }
  }
}
