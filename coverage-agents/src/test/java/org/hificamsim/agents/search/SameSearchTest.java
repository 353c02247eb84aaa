package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The searches go where they went, node by node: where a limit ends one, that decides its result.
 * Who changes a heuristic on purpose sees here what it takes: the numbers are sums over fixed
 * random problems, given as cameras, targets and how many of a hundred targets a set holds.
 */
class SameSearchTest {
  private static final int TRIALS = 30;
  private static final int SETS = 4;

  @ParameterizedTest
  @CsvSource({"12, 24, 40, 531, 107, 111", "9, 100, 60, 641, 89, 104", "20, 40, 20, 744, 65, 75"})
  void forCoverage(int cameras, int targets, int percent, long nodes, int value, int bound) {
    long[] sums = new long[3];
    each(
        cameras,
        targets,
        percent,
        problem -> {
          CoverageSolver solver = new CoverageSolver(problem, CoverageSolver.UNLIMITED);
          solver.solve();
          sums[0] += solver.nodes();
          CoverageSolver limited = new CoverageSolver(problem, 3);
          limited.solve();
          sums[1] += limited.value();
          sums[2] += limited.bound();
          assertEquals(limited.bound() - limited.value(), limited.gap());
        });
    assertEquals(nodes + " " + value + " " + bound, sums[0] + " " + sums[1] + " " + sums[2]);
  }

  /**
   * What one half of the cameras sees has nothing to do with the other: neither is searched twice.
   */
  @Test
  void forCoverageOfTwoFieldsApart() {
    SplittableRandom random = new SplittableRandom(1);
    long nodes = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
      CoverageSolver solver =
          new CoverageSolver(Problems.apart(random, 10, SETS, 40), CoverageSolver.UNLIMITED);
      solver.solve();
      nodes += solver.nodes();
    }
    assertEquals(256, nodes);
  }

  @ParameterizedTest
  @CsvSource({
    "covered:k=1, 20, 40, 12, 600, 29.8, 29.95",
    "covered:k=2, 20, 40, 20, 804, 29.875, 29.95",
    "sum:cap=2, 20, 100, 8, 59198, 4557, 4633",
    "sum:cap=3, 12, 24, 20, 2753, 1824, 1866",
    "lexicographic, 12, 24, 20, 17812, 37, 65",
    "lexicographic, 9, 100, 30, 11085, 21, 49"
  })
  void forValues(
      String text, int cameras, int targets, int percent, long nodes, double value, double bound) {
    Objective objective = Objective.parse(text);
    double[] sums = new double[3];
    each(
        cameras,
        targets,
        percent,
        problem -> {
          ValueSolver solver = new ValueSolver(objective, problem, 5_000);
          solver.solve();
          sums[0] += solver.nodes();
          ValueSolver limited = new ValueSolver(objective, problem, 3);
          limited.solve();
          sums[1] += limited.value();
          sums[2] += limited.bound();
          assertEquals(limited.bound() - limited.value(), limited.gap());
        });
    assertEquals(nodes, (long) sums[0]);
    assertEquals(value, sums[1], 1e-9);
    assertEquals(bound, sums[2], 1e-9);
  }

  /** The least coverage that each reaches from its first sets, with all the others in view. */
  @ParameterizedTest
  @CsvSource({"12, 24, 40, 82", "9, 100, 60, 63", "20, 40, 20, 39"})
  void byExchangesOfSingleSets(int cameras, int targets, int percent, int reached) {
    int[] sum = new int[1];
    each(
        cameras,
        targets,
        percent,
        problem -> {
          Remaining remaining = new Remaining(problem);
          remaining.reset();
          Choice choice = new Choice(problem);
          choice.reset();
          new LocalSearch(problem, remaining).reach(cameras, 10, choice);
          sum[0] += choice.least();
        });
    assertEquals(reached, sum[0]);
  }

  /** What weights bound the coverage by, all alike and tuned, and what these leave over. */
  @ParameterizedTest
  @CsvSource({
    "12, 24, 40, 145, 111, 77525946",
    "9, 100, 60, 134, 104, 90872906",
    "20, 40, 20, 97, 76, 89087046"
  })
  void byWeights(int cameras, int targets, int percent, int alike, int tuned, long surplus) {
    long[] sums = new long[3];
    each(
        cameras,
        targets,
        percent,
        problem -> {
          Domains domains = new Domains(problem);
          domains.reset();
          sums[0] += domains.bound();
          WeightTuning tuning = new WeightTuning(problem);
          tuning.reset();
          domains.weigh(tuning.tune(24, 0));
          sums[1] += domains.bound();
          sums[2] += domains.weights().surplus(domains.bound());
        });
    assertEquals(alike + " " + tuned + " " + surplus, sums[0] + " " + sums[1] + " " + sums[2]);
  }

  /** Bounds on a value, free and at a price, and what climbing reaches: in parts of a unit. */
  @ParameterizedTest
  @CsvSource({
    "covered:k=1, 9, 100, 8, 1772250480, 1378310988, 1345584240",
    "covered:k=2, 20, 100, 8, 1948106160, 1631932973, 1394593200",
    "sum:cap=3, 12, 24, 20, 1504142640, 1352014993, 1313872560"
  })
  void byPrices(
      String text, int cameras, int targets, int percent, long free, long priced, long climbed) {
    long[] sums = new long[3];
    each(
        cameras,
        targets,
        percent,
        problem -> {
          Decisions decisions = new Decisions(problem);
          decisions.reset();
          ValueBounds bounds = new Stages(Objective.parse(text), problem, decisions).bounds()[0];
          bounds.reset();
          sums[0] += bounds.look();
          sums[1] += bounds.tune();
          Choice choice = new Choice(problem);
          choice.reset();
          new ValueClimb(problem, new ValueBounds[] {bounds}).improve(0, choice);
          sums[2] += choice.value(bounds.worth());
        });
    assertEquals(free + " " + priced + " " + climbed, sums[0] + " " + sums[1] + " " + sums[2]);
  }

  private static void each(int cameras, int targets, int percent, Consumer<CoverageProblem> work) {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < TRIALS; trial++) {
      work.accept(Problems.wide(random, cameras, SETS, targets, percent / 100.0));
    }
  }
}
