package org.hificamsim.solver.configuration;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that the search visits the same nodes as before, which decide the result if a limit ends
 * it. If you change a heuristic on purpose, these numbers show the effect. They are sums over fixed
 * random problems, given by the number of cameras, the number of targets, and the percentage of
 * targets that a set holds.
 */
class SameSearchTest {
  private static final int TRIALS = 30;
  private static final int SETS = 4;

  @ParameterizedTest
  @CsvSource({
    "kmin, 12, 24, 40, 537, 97, 14",
    "kmin, 9, 100, 60, 521, 80, 23",
    "kmin, 20, 40, 20, 752, 66, 9",
    "covered:k=1, 20, 40, 12, 11, 29.925, 0.025",
    "covered:k=2, 20, 40, 20, 3, 29.95, 0",
    "sum:cap=2, 20, 100, 8, 8383, 4553, 190",
    "sum:cap=3, 12, 24, 20, 371, 1847, 34",
    "lexicographic, 12, 24, 20, 3192, 37, 28",
    "lexicographic, 9, 100, 30, 3355, 21, 32"
  })
  void searchVisitsTheSameNodes(
      String text, int cameras, int targets, int percent, long nodes, double score, double gap) {
    Objective objective = Objective.parse(text);
    double[] sums = new double[3];
    forEachProblem(
        cameras,
        targets,
        percent,
        problem -> {
          StepSolver solver = new StepSolver(objective, problem, 5_000);
          solver.solve();
          sums[0] += solver.nodes();
          StepSolver limited = new StepSolver(objective, problem, 3);
          limited.solve();
          sums[1] += limited.score();
          sums[2] += limited.gap();
        });
    assertEquals(
        String.format(Locale.ROOT, "%d %.3f %.3f", nodes, score, gap),
        String.format(Locale.ROOT, "%.0f %.3f %.3f", sums[0], sums[1], sums[2]));
  }

  @Test
  void searchOfTwoSeparateHalvesVisitsTheSameNodes() {
    SplittableRandom random = new SplittableRandom(1);
    long nodes = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
      CoverageProblem problem = Problems.twoHalves(random, 10, SETS, 40);
      StepSolver solver = new StepSolver(Objective.kMin(), problem, Solver.UNLIMITED);
      solver.solve();
      nodes += solver.nodes();
    }
    assertEquals(212, nodes);
  }

  /**
   * The value bounded by the range alone and by prices, and the value that local search reaches.
   */
  @ParameterizedTest
  @CsvSource({
    "kmin, 12, 24, 40, 163, 111, 99",
    "kmin, 20, 40, 20, 101, 75, 69",
    "covered:k=1, 9, 100, 8, 1796754960, 1389596709, 1349908560",
    "covered:k=2, 20, 100, 8, 1949547600, 1645333096, 1401079680",
    "sum:cap=3, 12, 24, 20, 1525043520, 1365093675, 1341259920"
  })
  void boundsAndLocalSearchGiveTheSameValues(
      String text,
      int cameras,
      int targets,
      int percent,
      long rangeBound,
      long priceBound,
      long reached) {
    long[] sums = new long[3];
    forEachProblem(
        cameras,
        targets,
        percent,
        problem -> {
          RemainingSets remaining = new RemainingSets(problem);
          remaining.reset();
          Stage[] stages = Stage.stages(Objective.parse(text), problem, remaining);
          Configuration configuration = new Configuration(problem);
          configuration.reset();
          long bound = stages[0].bound();
          sums[0] += bound;
          stages[0].require(bound);
          new LocalSearch(problem, remaining, stages).improve(1, 10, configuration);
          long value = stages[0].value(configuration.coverage());
          sums[2] += value;
          stages[0].require(value + stages[0].step());
          stages[0].tunePrices(40);
          sums[1] += stages[0].bound();
        });
    assertEquals(
        rangeBound + " " + priceBound + " " + reached, sums[0] + " " + sums[1] + " " + sums[2]);
  }

  private static void forEachProblem(
      int cameras, int targets, int percent, Consumer<CoverageProblem> test) {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < TRIALS; trial++) {
      test.accept(
          Problems.problem(
              targets, Problems.random(random, cameras, SETS, targets, percent / 100.0)));
    }
  }
}
