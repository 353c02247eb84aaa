package org.hificamsim.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.hificamsim.bench.OptimumInstance.Density;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.configuration.StepSolver;

/**
 * Measures the time of proofs of optimality on 30 instances of each {@link Density}, on one thread.
 * It writes the instances and {@code ours.csv} into a folder, where {@code
 * bench/peers/optimum_cpsat.py} finds them.
 */
public final class OptimumTimes {
  private static final int SEEDS = 30;
  private static final int WARM_UP = 100;

  private OptimumTimes() {}

  /**
   * Measures and writes the times.
   *
   * @param args the folder and, if not 1,000,000, the greatest number of search nodes
   */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    long nodes = args.length > 1 ? Long.parseLong(args[1]) : 1_000_000;
    CoverageProblem problem = OptimumInstance.emptyProblem();
    StepSolver solver = new StepSolver(Objective.kMin(), problem, nodes);
    for (int seed = 0; seed < WARM_UP; seed++) {
      OptimumInstance.random(Density.CLUSTER, SEEDS + seed).fill(problem);
      solver.solve();
    }
    List<String> rows = new ArrayList<>();
    rows.add("density,seed,value,bound,nodes,cpu_ms");
    for (Density density : Density.values()) {
      for (int seed = 0; seed < SEEDS; seed++) {
        OptimumInstance instance = OptimumInstance.random(density, seed);
        String name = density.name().toLowerCase(Locale.ROOT) + "-" + seed;
        Files.writeString(folder.resolve(name + ".json"), instance.json() + "\n");
        instance.fill(problem);
        rows.add(name.replace('-', ',') + "," + row(solver));
        System.out.println(rows.get(rows.size() - 1));
      }
    }
    Files.write(folder.resolve("ours.csv"), rows);
  }

  private static String row(StepSolver solver) {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadCpuTime();
    solver.solve();
    double milliseconds = (threads.getCurrentThreadCpuTime() - before) / 1e6;
    return String.format(
        Locale.ROOT,
        "%.0f,%.0f,%d,%.3f",
        solver.score(),
        solver.score() + solver.gap(),
        solver.nodes(),
        milliseconds);
  }
}
