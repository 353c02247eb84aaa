package org.hificamsim.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.configuration.Solver;
import org.hificamsim.solver.configuration.StepSolver;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the microseconds to fill a problem with an instance and to find its optimum with proof.
 * The instances, solved in turn, are those of a file that {@code bench/peers/step_instances.py}
 * wrote. Their optima go into another file in its folder: {@code FILE.values} for kmin, {@code
 * FILE-OBJECTIVE.values} for any other objective.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class StepOptimumBenchmark {
  /**
   * An instance of the optimum.
   *
   * @param cameras for each camera and level, the targets in sight, as bits
   */
  private record Instance(int targets, long[][] cameras) {
    static Instance of(JsonNode json) {
      long[][] cameras = new long[json.get("cameras").size()][];
      for (int camera = 0; camera < cameras.length; camera++) {
        JsonNode levels = json.get("cameras").get(camera);
        cameras[camera] = new long[levels.size()];
        for (int level = 0; level < levels.size(); level++) {
          for (JsonNode target : levels.get(level)) {
            cameras[camera][level] |= 1L << target.intValue();
          }
        }
      }
      return new Instance(json.get("targets").intValue(), cameras);
    }

    int sets() {
      int count = 0;
      for (long[] camera : cameras) {
        count += camera.length;
      }
      return count;
    }

    void fill(CoverageProblem problem) {
      problem.clear(targets);
      for (long[] camera : cameras) {
        problem.addCamera();
        for (int level = camera.length - 1; level >= 0; level--) {
          problem.addSet(camera, level);
        }
      }
    }
  }

  @Param({"build/bench/general.jsonl"})
  private String instances;

  private final List<Instance> parsedInstances = new ArrayList<>();
  private CoverageProblem problem;

  @Param({"kmin"})
  private String objective;

  private Objective parsedObjective;
  private Solver solver;
  private int[] counts;
  private int next;

  /** Reads the instances, at most 64 targets each, and writes their optima. */
  @Setup
  public void start() throws IOException {
    ObjectMapper json = new ObjectMapper();
    for (String line : Files.readAllLines(Path.of(instances))) {
      parsedInstances.add(Instance.of(json.readTree(line)));
    }
    int cameras =
        parsedInstances.stream()
            .mapToInt(instance -> instance.cameras().length)
            .max()
            .orElseThrow();
    int sets = parsedInstances.stream().mapToInt(Instance::sets).max().orElseThrow();
    problem = new CoverageProblem(cameras, sets, Long.SIZE);
    parsedObjective = Objective.parse(objective);
    solver = new StepSolver(parsedObjective, problem, Solver.UNLIMITED);
    counts = new int[Long.SIZE];
    List<String> values = new ArrayList<>();
    for (Instance instance : parsedInstances) {
      solve();
      values.add(score(instance));
    }
    String name =
        parsedObjective.equals(Objective.kMin()) ? instances : instances + "-" + objective;
    Files.write(Path.of(name + ".values"), values);
  }

  /**
   * Returns the score of the solution; for {@code covered}, the number of targets instead of their
   * share.
   */
  private String score(Instance instance) {
    Arrays.fill(counts, 0);
    for (int camera = 0; camera < instance.cameras().length; camera++) {
      for (int target = 0; target < instance.targets(); target++) {
        counts[target] += problem.contains(solver.chosen(camera), target) ? 1 : 0;
      }
    }
    double factor = parsedObjective instanceof Objective.Covered ? instance.targets() : 1;
    return Long.toString(Math.round(factor * parsedObjective.score(counts, 0, instance.targets())));
  }

  /** Fills and solves the next instance; returns whether its optimum is proven. */
  @Benchmark
  public boolean solve() {
    parsedInstances.get(next).fill(problem);
    next = (next + 1) % parsedInstances.size();
    solver.solve();
    return solver.proven();
  }
}
