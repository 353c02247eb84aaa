package org.hificamsim.ortools;

import com.google.ortools.Loader;
import com.google.ortools.linearsolver.MPConstraint;
import com.google.ortools.linearsolver.MPObjective;
import com.google.ortools.linearsolver.MPSolver;
import com.google.ortools.linearsolver.MPVariable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.ExactMethod;
import org.hificamsim.placement.cover.Goal;

/**
 * The mixed-integer solver SCIP, which comes with OR-Tools. A candidate is taken or not; how often
 * a sample is seen is a real number, so that the linear relaxation is strong and small. Samples
 * that the same candidates see, as often, are one. One thread: the same every time.
 */
public final class Scip implements ExactMethod {
  private static final long POLL = 50_000_000; // nanoseconds
  private static final int PATIENCE = 40; // times
  private static final double TOLERANCE = 1e-6; // of the solver, as a share

  /** Samples that the same candidates see. */
  private record Row(List<Integer> candidates, int needs) {}

  @Override
  public Found solve(
      CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop) {
    Loader.loadNativeLibraries();
    MPSolver solver = MPSolver.createSolver("SCIP");
    MPVariable[] taken = build(solver, instance, goal, start);
    MPSolver.ResultStatus status = solve(solver, stop);
    int[] best = start;
    double its = bound;
    if (status == MPSolver.ResultStatus.OPTIMAL || status == MPSolver.ResultStatus.FEASIBLE) {
      int[] plan =
          IntStream.range(0, taken.length).filter(j -> taken[j].solutionValue() > 0.5).toArray();
      best = better(instance, goal, plan, start) ? plan : start;
      double score = goal.score(instance, best);
      double found = solver.objective().bestBound();
      double margin = TOLERANCE * Math.max(1, Math.abs(score));
      double loose = Math.abs(found - score) <= margin ? 0 : goal.isAll() ? -margin : margin;
      found = loose == 0 ? score : found + loose;
      its = goal.isAll() ? Math.max(bound, found) : Math.min(bound, found);
    }
    return new Found(best, its);
  }

  private static boolean better(CoverInstance instance, Goal goal, int[] plan, int[] than) {
    double difference = goal.score(instance, plan) - goal.score(instance, than);
    return goal.isAll() ? difference < 0 : difference > 0 && goal.affords(instance.price(plan));
  }

  /** Returns a variable for each candidate. */
  private static MPVariable[] build(
      MPSolver solver, CoverInstance instance, Goal goal, int[] start) {
    MPVariable[] taken = solver.makeBoolVarArray(instance.candidates());
    double[] hints = new double[taken.length];
    Arrays.stream(start).forEach(j -> hints[j] = 1);
    MPObjective objective = solver.objective();
    objective.setOptimizationDirection(!goal.isAll());
    MPConstraint spent = solver.makeConstraint(0, goal.budget());
    for (int j = 0; j < taken.length; j++) {
      if (goal.isAll()) {
        objective.setCoefficient(taken[j], instance.prices()[j]);
      } else {
        spent.setCoefficient(taken[j], instance.prices()[j]);
      }
    }
    List<MPVariable> all = new ArrayList<>(Arrays.asList(taken));
    DoubleStream.Builder values = DoubleStream.builder();
    Arrays.stream(hints).forEach(values);
    rows(instance)
        .forEach(
            (row, unit) -> {
              MPConstraint seen =
                  solver.makeConstraint(goal.isAll() ? row.needs : 0, Double.POSITIVE_INFINITY);
              row.candidates.forEach(j -> seen.setCoefficient(taken[j], 1));
              if (!goal.isAll()) {
                MPVariable times = solver.makeNumVar(0, row.needs, "");
                seen.setCoefficient(times, -1);
                objective.setCoefficient(times, unit);
                all.add(times);
                values.add(
                    Math.min(row.needs, row.candidates.stream().mapToDouble(j -> hints[j]).sum()));
              }
            });
    solver.setHint(all.toArray(MPVariable[]::new), values.build().toArray());
    return taken;
  }

  /** The rows of an instance that count, with what each time that one is seen is worth. */
  private static Map<Row, Double> rows(CoverInstance instance) {
    List<List<Integer>> seenBy = new ArrayList<>();
    IntStream.range(0, instance.samples()).forEach(any -> seenBy.add(new ArrayList<>()));
    for (int j = 0; j < instance.candidates(); j++) {
      for (int sample : instance.columns()[j]) {
        seenBy.get(sample).add(j);
      }
    }
    Map<Row, Double> rows = new LinkedHashMap<>();
    for (int s = 0; s < seenBy.size(); s++) {
      int needs = Math.min(instance.needs()[s], seenBy.get(s).size());
      if (needs > 0) {
        rows.merge(new Row(seenBy.get(s), needs), instance.units()[s], Double::sum);
      }
    }
    return rows;
  }

  /** On a thread that is left alone where SCIP, amid a large linear program, does not stop. */
  private static MPSolver.ResultStatus solve(MPSolver solver, BooleanSupplier stop) {
    CompletableFuture<MPSolver.ResultStatus> end =
        CompletableFuture.supplyAsync(
            solver::solve,
            task -> {
              Thread thread = new Thread(task, "SCIP");
              thread.setDaemon(true);
              thread.start();
            });
    for (int waited = 0; waited < PATIENCE && !end.isDone(); ) {
      LockSupport.parkNanos(POLL);
      if (stop.getAsBoolean()) {
        solver.interruptSolve(); // again, as it may not have begun
        waited++;
      }
    }
    return end.getNow(MPSolver.ResultStatus.NOT_SOLVED);
  }
}
