package org.hificamsim.ortools;

import com.google.ortools.Loader;
import com.google.ortools.sat.BoolVar;
import com.google.ortools.sat.CpModel;
import com.google.ortools.sat.CpSolver;
import com.google.ortools.sat.CpSolverSolutionCallback;
import com.google.ortools.sat.CpSolverStatus;
import com.google.ortools.sat.IntVar;
import com.google.ortools.sat.LinearExpr;
import com.google.ortools.sat.LinearExprBuilder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.ExactMethod;
import org.hificamsim.placement.cover.Goal;

/**
 * CP-SAT of OR-Tools. Samples that the same candidates see, as often, are one. What it counts in
 * whole numbers is rounded so that its bound stays one. One worker: of several, the first to find a
 * plan decides which of the best it is.
 */
public final class CpSat implements ExactMethod {
  private static final long STEPS = 1L << 40; // of a total that has no common measure
  private static final long POLL = 50_000_000; // nanoseconds

  /** Samples that the same candidates see. */
  private record Row(List<Integer> candidates, int needs) {}

  @Override
  public Found solve(
      CoverInstance instance,
      Goal goal,
      int[] start,
      double bound,
      BooleanSupplier stop,
      CoverSearch.Watcher watcher) {
    Loader.loadNativeLibraries();
    return new Search(instance, goal, start, bound, watcher).run(stop);
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

  /** By how much numbers have to be multiplied to be whole, or nearly. */
  private static double scale(double[] values) {
    for (int scale = 1; scale <= 1000; scale++) {
      double by = scale;
      if (Arrays.stream(values).allMatch(v -> Math.abs(v * by - Math.rint(v * by)) < 1e-9)) {
        return by;
      }
    }
    return STEPS / Arrays.stream(values).sum();
  }

  /** Up or down, where rounding would not do. */
  private static long whole(double value, boolean up) {
    double nearest = Math.rint(value);
    boolean near = Math.abs(value - nearest) < 1e-6;
    return (long) (near ? nearest : up ? Math.ceil(value) : Math.floor(value));
  }

  private static final class Search {
    private final CoverInstance instance;
    private final Goal goal;
    private final CoverSearch.Watcher watcher;
    private final CpModel model = new CpModel();
    private final CpSolver solver = new CpSolver();
    private final BoolVar[] taken;
    private final double scale;
    private int[] best;
    private double bound;

    Search(
        CoverInstance instance, Goal goal, int[] start, double bound, CoverSearch.Watcher watcher) {
      this.instance = instance;
      this.goal = goal;
      this.watcher = watcher;
      this.best = start;
      this.bound = bound;
      this.taken = new BoolVar[instance.candidates()];
      Arrays.setAll(taken, j -> model.newBoolVar("x"));
      this.scale = goal.isAll() ? scale(instance.prices()) : scale(instance.units());
      boolean[] hinted = new boolean[taken.length];
      Arrays.stream(start).forEach(j -> hinted[j] = true);
      IntStream.range(0, taken.length).forEach(j -> model.addHint(taken[j], hinted[j]));
      build(rows(instance), hinted);
    }

    private void build(Map<Row, Double> rows, boolean[] hinted) {
      LinearExprBuilder objective = LinearExpr.newBuilder();
      rows.forEach(
          (row, unit) -> {
            LinearExprBuilder seen = LinearExpr.newBuilder();
            row.candidates.forEach(j -> seen.add(taken[j]));
            if (goal.isAll()) {
              model.addGreaterOrEqual(seen, row.needs);
            } else {
              IntVar times = model.newIntVar(0, row.needs, "y");
              model.addLessOrEqual(times, seen);
              long before = row.candidates.stream().filter(j -> hinted[j]).count();
              model.addHint(times, Math.min(row.needs, before));
              objective.addTerm(times, whole(unit * scale, true));
            }
          });
      LinearExprBuilder spent = LinearExpr.newBuilder();
      double cents = goal.isAll() ? scale : scale(instance.prices());
      for (int j = 0; j < taken.length; j++) {
        spent.addTerm(taken[j], whole(instance.prices()[j] * cents, false));
      }
      if (goal.isAll()) {
        model.minimize(spent);
      } else {
        model.addLessOrEqual(spent, whole(goal.budget() * cents, true));
        model.maximize(objective);
      }
    }

    Found run(BooleanSupplier stop) {
      solver.getParameters().setNumWorkers(1);
      Thread guard = new Thread(() -> guard(stop), "stops OR-Tools");
      guard.setDaemon(true);
      guard.start();
      try {
        CpSolverStatus status = solver.solve(model, new Plans());
        if (status == CpSolverStatus.OPTIMAL || status == CpSolverStatus.FEASIBLE) {
          bounded(solver.bestObjectiveBound()); // else it has none
        }
      } finally {
        guard.interrupt();
      }
      return new Found(best, bound);
    }

    private void guard(BooleanSupplier stop) {
      while (!Thread.currentThread().isInterrupted()) {
        LockSupport.parkNanos(POLL);
        if (stop.getAsBoolean()) {
          solver.stopSearch(); // again, as it may not have begun
        }
      }
    }

    /** Of the solver's two callbacks that of plans alone is safe: that of bounds has crashed. */
    private void bounded(double found) {
      double its = found / scale;
      if (goal.isAll() ? its > bound : its < bound) {
        bound = its;
        watcher.improved(score(), bound);
      }
    }

    private double score() {
      return goal.score(instance, best);
    }

    private void keep(int[] plan) {
      double before = score();
      double found = goal.score(instance, plan);
      boolean allowed = goal.isAll() || goal.affords(instance.price(plan));
      if (allowed && (goal.isAll() ? found < before : found > before)) {
        best = plan;
        watcher.improved(found, bound);
      }
    }

    private final class Plans extends CpSolverSolutionCallback {
      @Override
      public void onSolutionCallback() {
        bounded(bestObjectiveBound());
        keep(IntStream.range(0, taken.length).filter(j -> booleanValue(taken[j])).toArray());
      }
    }
  }
}
