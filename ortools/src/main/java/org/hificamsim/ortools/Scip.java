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
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.ExactMethod;
import org.hificamsim.solver.cover.Goal;

/**
 * Solves covering problems exactly by the mixed-integer solver SCIP, which comes with OR-Tools. A
 * candidate is a binary variable; the number of times that a point is covered is a real variable,
 * which keeps the linear relaxation strong and small. Points that the same candidates cover, and
 * that need the same number of them, are one row. SCIP runs on one thread, so that its result is
 * always the same.
 */
public final class Scip implements ExactMethod {
  private static final long POLL_NANOSECONDS = 50_000_000;

  /** The number of requests to stop after which SCIP's thread is abandoned. */
  private static final int MAX_STOP_REQUESTS = 40;

  /** The solver's tolerance, as a share of the score. */
  private static final double TOLERANCE = 1e-6;

  /** A group of points that the same candidates cover. */
  private record Row(List<Integer> candidates, int needs) {}

  @Override
  public Result solve(
      CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop) {
    Loader.loadNativeLibraries();
    MPSolver solver = MPSolver.createSolver("SCIP");
    MPVariable[] chosen = build(solver, instance, goal, start);
    MPSolver.ResultStatus status = solve(solver, stop);
    int[] best = start;
    double newBound = bound;
    if (status == MPSolver.ResultStatus.OPTIMAL || status == MPSolver.ResultStatus.FEASIBLE) {
      int[] plan =
          IntStream.range(0, chosen.length)
              .filter(candidate -> chosen[candidate].solutionValue() > 0.5)
              .toArray();
      best = isBetter(instance, goal, plan, start) ? plan : start;
      double solverBound = safeBound(goal, goal.score(instance, best), solver);
      newBound = goal.isFullCover() ? Math.max(bound, solverBound) : Math.min(bound, solverBound);
    }
    return new Result(best, newBound);
  }

  /** The solver's bound, loosened by its tolerance, or the score itself if it is that close. */
  private static double safeBound(Goal goal, double score, MPSolver solver) {
    double solverBound = solver.objective().bestBound();
    double margin = TOLERANCE * Math.max(1, Math.abs(score));
    if (Math.abs(solverBound - score) <= margin) {
      return score;
    }
    return goal.isFullCover() ? solverBound - margin : solverBound + margin;
  }

  private static boolean isBetter(CoverInstance instance, Goal goal, int[] plan, int[] start) {
    double difference = goal.score(instance, plan) - goal.score(instance, start);
    return goal.isFullCover()
        ? difference < 0
        : difference > 0 && goal.affords(instance.price(plan));
  }

  /** Adds the problem to the solver, and returns a variable for each candidate. */
  private static MPVariable[] build(
      MPSolver solver, CoverInstance instance, Goal goal, int[] start) {
    MPVariable[] chosen = solver.makeBoolVarArray(instance.candidates());
    double[] hints = new double[chosen.length];
    Arrays.stream(start).forEach(candidate -> hints[candidate] = 1);
    MPObjective objective = solver.objective();
    objective.setOptimizationDirection(!goal.isFullCover());
    MPConstraint spent = solver.makeConstraint(0, goal.budget());
    for (int candidate = 0; candidate < chosen.length; candidate++) {
      double price = instance.prices()[candidate];
      if (goal.isFullCover()) {
        objective.setCoefficient(chosen[candidate], price);
      } else {
        spent.setCoefficient(chosen[candidate], price);
      }
    }
    List<MPVariable> variables = new ArrayList<>(Arrays.asList(chosen));
    DoubleStream.Builder values = DoubleStream.builder();
    Arrays.stream(hints).forEach(values);
    rows(instance)
        .forEach(
            (row, unitWorth) -> {
              double least = goal.isFullCover() ? row.needs : 0;
              MPConstraint covered = solver.makeConstraint(least, Double.POSITIVE_INFINITY);
              row.candidates.forEach(candidate -> covered.setCoefficient(chosen[candidate], 1));
              if (!goal.isFullCover()) {
                MPVariable times = solver.makeNumVar(0, row.needs, "");
                covered.setCoefficient(times, -1);
                objective.setCoefficient(times, unitWorth);
                variables.add(times);
                double hint =
                    row.candidates.stream().mapToDouble(candidate -> hints[candidate]).sum();
                values.add(Math.min(row.needs, hint));
              }
            });
    solver.setHint(variables.toArray(MPVariable[]::new), values.build().toArray());
    return chosen;
  }

  /** Returns the rows that count, with the worth of covering each row once. */
  private static Map<Row, Double> rows(CoverInstance instance) {
    List<List<Integer>> coveringCandidates = new ArrayList<>();
    for (int point = 0; point < instance.points(); point++) {
      coveringCandidates.add(new ArrayList<>());
    }
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      for (int point : instance.covered()[candidate]) {
        coveringCandidates.get(point).add(candidate);
      }
    }
    Map<Row, Double> rows = new LinkedHashMap<>();
    for (int point = 0; point < coveringCandidates.size(); point++) {
      List<Integer> candidates = coveringCandidates.get(point);
      int needs = Math.min(instance.needs()[point], candidates.size());
      if (needs > 0) {
        rows.merge(new Row(candidates, needs), instance.unitWorths()[point], Double::sum);
      }
    }
    return rows;
  }

  /**
   * Solves the problem on a thread of its own, which is abandoned if SCIP does not stop because it
   * is in a large linear program.
   */
  private static MPSolver.ResultStatus solve(MPSolver solver, BooleanSupplier stop) {
    CompletableFuture<MPSolver.ResultStatus> result =
        CompletableFuture.supplyAsync(
            solver::solve,
            task -> {
              Thread thread = new Thread(task, "SCIP");
              thread.setDaemon(true);
              thread.start();
            });
    int stopRequests = 0;
    while (stopRequests < MAX_STOP_REQUESTS && !result.isDone()) {
      LockSupport.parkNanos(POLL_NANOSECONDS);
      if (stop.getAsBoolean()) {
        solver.interruptSolve(); // repeated, because a request before the start is lost
        stopRequests++;
      }
    }
    return result.getNow(MPSolver.ResultStatus.NOT_SOLVED);
  }
}
