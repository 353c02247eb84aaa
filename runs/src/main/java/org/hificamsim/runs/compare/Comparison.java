package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoredRun;

/**
 * Runs plans side by side, every repeat a task of its own, and scores each run against the exact
 * optimum of its scenario, detection model and seed.
 *
 * <p>The results do not depend on the engine or its threads: a run depends on its plan and seed
 * alone, and sums over runs are sums of whole numbers, or added in the order of seeds.
 */
public final class Comparison {
  private final RunEngine engine;
  private final RunProgress progress;

  /**
   * @param engine where the runs are computed, configured
   * @param progress hears of each run
   */
  public Comparison(RunEngine engine, RunProgress progress) {
    this.engine = engine;
    this.progress = progress;
  }

  /**
   * Runs all plans.
   *
   * @param plans made by {@link Yardsticks#with}; all with the same seeds
   * @return one result per plan, in their order
   * @throws org.hificamsim.core.InputException when the journal has runs of other inputs that have
   *     the names of these
   */
  List<CaseResult> run(List<RunPlan> plans, Journal journal) throws IOException {
    List<RunKey> keys = RunKey.of(plans);
    journal.requireUnchanged(keys);
    List<CaseUnderWay> cases = new ArrayList<>();
    for (RunPlan plan : plans) {
      cases.add(new CaseUnderWay(plan, keys.get(cases.size()).text()));
    }
    List<RunTask> all = tasks(plans);
    List<RunTask> missing = new ArrayList<>();
    for (RunTask task : all) {
      CaseUnderWay one = cases.get(task.plan());
      Optional<Outcome> found = journal.find(one.key, one.plan.seed(task.repeat()));
      if (found.isPresent()) {
        one.take(task.repeat(), found.get());
      } else {
        missing.add(task);
      }
    }
    progress.resume(all.size() - missing.size());
    engine.run(
        plans,
        missing,
        (task, outcome) -> {
          CaseUnderWay one = cases.get(task.plan());
          journal.add(one.key, one.plan.seed(task.repeat()), outcome);
          one.take(task.repeat(), outcome);
          progress.advance();
        });
    return score(cases);
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
    Map<Yardsticks.Group, CaseUnderWay> optima = byGroup(cases, Yardsticks.OPTIMAL);
    Map<Yardsticks.Group, CaseUnderWay> fixed = byGroup(cases, Yardsticks.BEST_FIXED);
    return cases.stream()
        .map(
            one -> {
              Yardsticks.Group group = Yardsticks.Group.of(one.plan);
              return one.scored(optima.get(group), Optional.ofNullable(fixed.get(group)));
            })
        .toList();
  }

  private static Map<Yardsticks.Group, CaseUnderWay> byGroup(
      List<CaseUnderWay> cases, String policy) {
    Map<Yardsticks.Group, CaseUnderWay> found = new LinkedHashMap<>();
    cases.stream()
        .filter(one -> one.plan.policy().equals(policy))
        .forEach(one -> found.put(Yardsticks.Group.of(one.plan), one));
    return found;
  }

  /** A plan whose repeats are being run, by several threads. */
  private static final class CaseUnderWay {
    private final RunPlan plan;
    private final String key;
    private final Outcome[] outcomes;
    private final double[] settling;
    private final double[][] levels;
    private final double[] sums; // of whole numbers, exact; at the end the means

    CaseUnderWay(RunPlan plan, String key) {
      this.plan = plan;
      this.key = key;
      this.outcomes = new Outcome[plan.repeats()];
      this.settling = new double[plan.repeats()];
      this.levels = new double[plan.repeats()][];
      this.sums = new double[plan.steps()];
    }

    synchronized void take(int repeat, Outcome outcome) {
      for (int step = 0; step < sums.length; step++) {
        sums[step] += outcome.kMin()[step];
      }
      settling[repeat] = Settling.of(outcome.kMin());
      levels[repeat] = PartMeans.of(outcome.kMin());
      outcomes[repeat] = new Outcome(outcome.result().asRun(repeat), new int[0]);
    }

    CaseResult scored(CaseUnderWay optimum, Optional<CaseUnderWay> fixed) {
      List<ScoredRun> runs = new ArrayList<>();
      for (int repeat = 0; repeat < outcomes.length; repeat++) {
        runs.add(
            new ScoredRun(
                outcomes[repeat].result(),
                optimum.score(repeat),
                fixed.isPresent() ? fixed.get().score(repeat) : Double.NaN,
                settling[repeat]));
      }
      Arrays.setAll(sums, step -> sums[step] / runs.size());
      return new CaseResult(plan, runs, sums, levels);
    }

    private double score(int repeat) {
      return outcomes[repeat].result().score();
    }
  }
}
