package org.hificamsim.network.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunTask;

/** The measurements of the runs of a study: about a hundred bytes per run of any length. */
public final class StudyResults {
  /** The metrics kept for each run. */
  static final List<Metric> KEPT =
      List.of(
          Metric.PERFORMANCE,
          Metric.COVERED_0,
          Metric.COVERED_1,
          Metric.COVERED_K,
          Metric.SCORE,
          Metric.UTILITY,
          Metric.MESSAGES,
          Metric.INVITATIONS,
          Metric.HANDOVERS,
          Metric.OVERLAP,
          Metric.CONFIDENCE,
          Metric.TRACKED,
          Metric.BITS);

  private final List<StudyPlan> plans = new ArrayList<>();
  private final Map<String, Integer> planIndexes = new HashMap<>();

  /** The metrics of each plan: the {@link #KEPT} ones of the first repeat, then of the second... */
  private final List<double[]> figures = new ArrayList<>();

  /**
   * Runs all repeats of networks that were not run yet, seed by seed, so that all progress evenly.
   */
  public void run(List<StudyPlan> newPlans, RunEngine engine) throws IOException {
    int first = plans.size();
    for (StudyPlan plan : newPlans) {
      if (planIndexes.putIfAbsent(key(plan), plans.size()) == null) {
        plans.add(plan);
        figures.add(new double[plan.plan().repeats() * KEPT.size()]);
      }
    }
    List<RunPlan> added = plans.subList(first, plans.size()).stream().map(StudyPlan::plan).toList();
    List<RunTask> tasks = new ArrayList<>();
    for (int repeat = 0; repeat < newPlans.get(0).plan().repeats(); repeat++) {
      for (int plan = 0; plan < added.size(); plan++) {
        tasks.add(new RunTask(plan, repeat));
      }
    }
    engine.run(added, tasks, (task, run) -> keep(first + task.plan(), task.repeat(), run.result()));
  }

  private static String key(StudyPlan plan) {
    return plan.plan().scenario().name() + " " + plan.label();
  }

  /** The mean of a metric over the seeds of a network that was run. */
  double mean(StudyPlan plan, Metric metric) {
    return Arrays.stream(values(planIndexes.get(key(plan)), metric)).average().orElse(0);
  }

  /** Keeps a result; concurrent runs write to different parts of the array. */
  private void keep(int plan, int repeat, RunResult result) {
    for (int i = 0; i < KEPT.size(); i++) {
      figures.get(plan)[repeat * KEPT.size() + i] = result.value(KEPT.get(i));
    }
  }

  /** The networks, in the order in which they were given. */
  public List<StudyPlan> plans() {
    return plans;
  }

  /** The values of a metric for a network, one for each seed. */
  public double[] values(int plan, Metric metric) {
    int metricIndex = KEPT.indexOf(metric);
    return IntStream.range(0, plans.get(plan).plan().repeats())
        .mapToDouble(repeat -> figures.get(plan)[repeat * KEPT.size() + metricIndex])
        .toArray();
  }

  /** Returns all runs of a network. */
  Stream<RunResult> runs(int plan) {
    RunPlan runPlan = plans.get(plan).plan();
    return IntStream.range(0, runPlan.repeats())
        .mapToObj(repeat -> run(plan, repeat, runPlan.seed(repeat)));
  }

  private RunResult run(int plan, int repeat, long seed) {
    Map<Metric, Double> values = new EnumMap<>(Metric.class);
    for (int i = 0; i < KEPT.size(); i++) {
      values.put(KEPT.get(i), figures.get(plan)[repeat * KEPT.size() + i]);
    }
    return RunResult.of(repeat, seed, values);
  }
}
