package org.hificamsim.experiments.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.experiments.run.RunExecutor;
import org.hificamsim.experiments.run.RunPlan;

/**
 * Runs plans side by side, every repeat a task of its own, and scores each run against the exact
 * optimum of its scenario, detection model and seed.
 *
 * <p>The results do not depend on the number of threads: a run depends on its plan and seed alone,
 * and sums over runs are sums of whole numbers.
 */
public final class Comparison {
  static final String OPTIMAL = "optimal";

  private record Yardstick(Scenario scenario, Detection detection, int steps) {
    static Yardstick of(RunPlan plan) {
      return new Yardstick(plan.scenario(), plan.detection(), plan.steps());
    }
  }

  private final RunExecutor executor;
  private final int threads;
  private final Runnable runFinished;

  /**
   * @param runFinished called after each run, from any thread
   */
  public Comparison(RunExecutor executor, int threads, Runnable runFinished) {
    this.executor = executor;
    this.threads = threads;
    this.runFinished = runFinished;
  }

  /** The plans asked for, then the optimum of every scenario and detection where it is missing. */
  public static List<RunPlan> withOptimum(List<RunPlan> plans) {
    Map<Yardstick, RunPlan> missing = new LinkedHashMap<>();
    for (RunPlan plan : plans) {
      missing.putIfAbsent(Yardstick.of(plan), plan.withPolicy(OPTIMAL));
    }
    plans.stream()
        .filter(plan -> plan.policy().equals(OPTIMAL))
        .forEach(plan -> missing.remove(Yardstick.of(plan)));
    List<RunPlan> all = new ArrayList<>(plans);
    all.addAll(missing.values());
    return all;
  }

  /**
   * Runs all plans.
   *
   * @param plans made by {@link #withOptimum}; all with the same seeds
   * @return one result per plan, in their order
   */
  List<CaseResult> run(List<RunPlan> plans, Journal journal) throws IOException {
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    try {
      List<CaseUnderWay> cases = plans.stream().map(CaseUnderWay::new).toList();
      List<Future<?>> tasks = new ArrayList<>();
      for (int run = 0; run < plans.get(0).repeats(); run++) {
        for (CaseUnderWay one : cases) {
          int repeat = run;
          tasks.add(
              pool.submit(
                  () -> {
                    one.run(repeat, journal);
                    return null;
                  }));
        }
      }
      for (Future<?> task : tasks) {
        await(task);
      }
      return score(cases);
    } finally {
      pool.shutdownNow();
    }
  }

  private static void await(Future<?> task) throws IOException {
    try {
      task.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException fault) {
        throw fault;
      }
      if (e.getCause() instanceof IOException fault) {
        throw fault;
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  private static List<CaseResult> score(List<CaseUnderWay> cases) {
    Map<Yardstick, CaseUnderWay> optima = new LinkedHashMap<>();
    for (CaseUnderWay one : cases) {
      if (one.plan.policy().equals(OPTIMAL)) {
        optima.put(Yardstick.of(one.plan), one);
      }
    }
    return cases.stream().map(one -> one.scored(optima.get(Yardstick.of(one.plan)))).toList();
  }

  /** A plan whose repeats are being run, by several threads. */
  private final class CaseUnderWay {
    private final RunPlan plan;
    private final String key;
    private final Outcome[] outcomes;
    private final double[] settling;
    private final long[] sums;

    CaseUnderWay(RunPlan plan) {
      this.plan = plan;
      this.key = RunKey.of(plan);
      this.outcomes = new Outcome[plan.repeats()];
      this.settling = new double[plan.repeats()];
      this.sums = new long[plan.steps()];
    }

    void run(int repeat, Journal journal) throws IOException {
      Outcome outcome = journal.find(key, plan.seed(repeat)).orElse(null);
      if (outcome == null) {
        outcome = simulate(repeat);
        journal.add(key, plan.seed(repeat), outcome);
      }
      take(repeat, outcome);
      runFinished.run();
    }

    private Outcome simulate(int repeat) {
      int[] kMin = new int[plan.steps()];
      return new Outcome(
          executor.repeat(
              plan,
              repeat,
              List.of((network, coverage) -> kMin[(int) network.step()] = coverage.kMin())),
          kMin);
    }

    private synchronized void take(int repeat, Outcome outcome) {
      for (int step = 0; step < sums.length; step++) {
        sums[step] += outcome.kMin()[step];
      }
      settling[repeat] = Settling.of(outcome.kMin());
      outcomes[repeat] = new Outcome(outcome.result().asRun(repeat), new int[0]);
    }

    CaseResult scored(CaseUnderWay optimum) {
      List<ScoredRun> runs = new ArrayList<>();
      for (int repeat = 0; repeat < outcomes.length; repeat++) {
        runs.add(
            new ScoredRun(
                outcomes[repeat].result(),
                optimum.outcomes[repeat].result().performance(),
                settling[repeat]));
      }
      return new CaseResult(
          plan, runs, Arrays.stream(sums).mapToDouble(sum -> sum / (double) runs.size()).toArray());
    }
  }
}
