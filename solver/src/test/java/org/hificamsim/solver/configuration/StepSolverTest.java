package org.hificamsim.solver.configuration;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class StepSolverTest {
  @ParameterizedTest
  @CsvSource({
    "kmin, 4000",
    "covered:k=1, 2000",
    "covered:k=2, 2000",
    "covered:k=3, 2000",
    "covered:k=99, 2000",
    "sum:cap=1, 2000",
    "sum:cap=2, 2000",
    "sum:cap=3, 2000",
    "sum:cap=99, 2000",
    "lexicographic, 2000"
  })
  void findsThePreferredBestConfigurationOfSmallProblems(String text, int trials) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(1);
    CoverageProblem problem = new CoverageProblem(8, 40, 80);
    StepSolver solver = new StepSolver(objective, problem, Solver.UNLIMITED);
    for (int trial = 0; trial < trials; trial++) {
      int targets = random.nextInt(9);
      double density = random.nextDouble();
      boolean[][][] sets = Problems.random(random, random.nextInt(7), 4, targets, density);
      assertIsBest(objective, targets, sets, problem, solver);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "kmin",
        "covered:k=1",
        "covered:k=2",
        "sum:cap=2",
        "sum:cap=3",
        "sum:cap=9",
        "lexicographic"
      })
  void findsThePreferredBestConfigurationOfManyTargets(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(2);
    CoverageProblem problem = new CoverageProblem(9, 40, 150);
    StepSolver solver = new StepSolver(objective, problem, Solver.UNLIMITED);
    for (int trial = 0; trial < 30; trial++) {
      int targets = 65 + random.nextInt(80);
      boolean[][][] sets = Problems.random(random, 9, 2, targets, random.nextDouble());
      assertIsBest(objective, targets, sets, problem, solver);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=2", "sum:cap=3", "lexicographic"})
  void findsThePreferredBestConfigurationAfterLongSearch(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(3);
    CoverageProblem problem = new CoverageProblem(9, 27, 12);
    StepSolver solver = new StepSolver(objective, problem, Solver.UNLIMITED);
    for (int trial = 0; trial < 60; trial++) {
      boolean[][][] sets = Problems.random(random, 9, 3, 12, 0.4);
      assertIsBest(objective, 12, sets, problem, solver);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=2", "sum:cap=3", "lexicographic"})
  void needsNoSearchIfOneSetIncludesAllOthers(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(8);
    CoverageProblem problem = new CoverageProblem(6, 24, 10);
    StepSolver solver = new StepSolver(objective, problem, Solver.UNLIMITED);
    for (int trial = 0; trial < 800; trial++) {
      int targets = 1 + random.nextInt(10);
      boolean[][][] sets = Problems.random(random, 1 + random.nextInt(6), 4, targets, 0.6);
      for (boolean[][] camera : sets) {
        boolean[] largest = camera[random.nextInt(camera.length)];
        for (int target = 0; target < targets; target++) {
          int number = target;
          largest[target] = Arrays.stream(camera).anyMatch(set -> set[number]);
        }
      }
      assertIsBest(objective, targets, sets, problem, solver);
      assertEquals(0, solver.nodes());
    }
  }

  /** The expected scores and configurations are those of an earlier implementation. */
  @ParameterizedTest
  @CsvSource({
    "kmin, 12, 24, 40, 110.0, -595215243",
    "kmin, 9, 100, 60, 90.0, -286217482",
    "kmin, 20, 40, 20, 71.0, -707546243",
    "kmin, 40, 30, 10, 97.0, 2047605595",
    "covered:k=1, 20, 40, 12, 29.95, -1551461428",
    "covered:k=1, 30, 70, 6, 29.357142857, 842944595",
    "covered:k=2, 20, 40, 20, 29.95, 1443763775",
    "covered:k=3, 14, 30, 30, 29.766666667, 2127969841",
    "sum:cap=2, 12, 60, 8, 1995.0, 82896927",
    "sum:cap=3, 12, 24, 20, 1864.0, 313608334",
    "lexicographic, 12, 24, 20, 39.0, 992282585",
    "lexicographic, 9, 100, 30, 25.0, 688708491"
  })
  void findsTheSameConfigurationsAsEarlierVersions(
      String text, int cameras, int targets, int percent, double scores, int configurations) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(1);
    double sum = 0;
    int hash = 1;
    for (int trial = 0; trial < 30; trial++) {
      boolean[][][] sets = Problems.random(random, cameras, 4, targets, percent / 100.0);
      StepSolver solver =
          new StepSolver(objective, Problems.problem(targets, sets), Solver.UNLIMITED);
      solver.solve();
      assertTrue(solver.proven());
      sum += solver.score();
      for (int camera = 0; camera < cameras; camera++) {
        hash = 31 * hash + solver.chosen(camera);
      }
    }
    assertEquals(scores, sum, 1e-8);
    assertEquals(configurations, hash);
  }

  @Test
  void camerasTakeTheirFirstSetWithoutTargets() {
    StepSolver solver = solve("kmin", 0, new long[][] {{0, 0}, {0}});
    assertEquals(0, solver.chosen(0));
    assertEquals(2, solver.chosen(1));
    assertTrue(solver.proven());
  }

  @Test
  void scoreIsZeroWithoutCameras() {
    for (String objective : new String[] {"kmin", "covered", "sum", "lexicographic"}) {
      StepSolver solver = solve(objective, 3, new long[][] {});
      assertEquals(0, solver.score());
      assertTrue(solver.proven());
    }
  }

  @Test
  void camerasTakeTheirFirstSetIfATargetIsOutOfReach() {
    StepSolver solver = solve("kmin", 2, new long[][] {{0, 1}, {1, 0}});
    assertEquals(0, solver.score());
    assertEquals(0, solver.chosen(0));
    assertEquals(2, solver.chosen(1));
  }

  @Test
  void limitedSearchBoundsTheBestScore() {
    SplittableRandom random = new SplittableRandom(3);
    int unproven = 0;
    for (int trial = 0; trial < 1_500; trial++) {
      String[] texts = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=2", "lexicographic"};
      Objective objective = Objective.parse(texts[trial % 5]);
      boolean[][][] sets = Problems.random(random, 7, 4, 8, 0.4);
      StepSolver solver = new StepSolver(objective, Problems.problem(8, sets), trial % 3);
      solver.solve();
      double best = Exhaustive.solve(objective, 8, sets).score();
      assertEquals(
          Exhaustive.score(objective, 8, sets, configuration(solver, sets)), solver.score());
      assertTrue(solver.score() <= best && best <= solver.score() + solver.gap() + 1e-12);
      assertTrue(!solver.proven() || (solver.gap() == 0 && solver.score() == best));
      assertTrue(solver.nodes() <= trial % 3 + 28L * StepSolver.MAX_TIE_NODES);
      unproven += solver.proven() ? 0 : 1;
    }
    assertTrue(unproven > 10, "no case in which the limit mattered");
  }

  @Test
  void nodeLimitAppliesToEachCallAnew() {
    SplittableRandom random = new SplittableRandom(7);
    int searched = 0;
    for (int trial = 0; trial < 300; trial++) {
      boolean[][][] sets = Problems.random(random, 7, 4, 8, 0.4);
      StepSolver solver = new StepSolver(Objective.kMin(), Problems.problem(8, sets), 2);
      solver.solve();
      long nodes = solver.nodes();
      double gap = solver.gap();
      int[] configuration = configuration(solver, sets);
      solver.solve();
      assertEquals(nodes, solver.nodes());
      assertEquals(gap, solver.gap());
      assertArrayEquals(configuration, configuration(solver, sets));
      searched += nodes > 0 ? 1 : 0;
    }
    assertTrue(searched > 0, "no case that is searched");
  }

  @Test
  void provesANetworkOfTwoHundredCameras() {
    SplittableRandom random = new SplittableRandom(6);
    boolean[][][] sets = new boolean[200][5][40];
    for (boolean[][] camera : sets) {
      int first = random.nextInt(40);
      for (boolean[] set : camera) {
        for (int target = first; target < first + 6; target++) {
          set[target % 40] = random.nextBoolean();
        }
      }
    }
    StepSolver solver = new StepSolver(Objective.kMin(), Problems.problem(40, sets), 100_000);
    solver.solve();
    assertTrue(solver.proven(), "lacks " + solver.gap());
    assertTrue(solver.score() > 10, "covered " + solver.score() + " times");
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=3", "lexicographic"})
  void allocatesNothingWhileItSolves(String text) {
    boolean[][][] sets = Problems.random(new SplittableRandom(4), 9, 4, 70, 0.3);
    CoverageProblem problem = Problems.problem(70, sets);
    StepSolver solver = new StepSolver(Objective.parse(text), problem, 10_000);
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(solver::solve)));
  }

  private static StepSolver solve(String objective, int targets, long[][] masks) {
    CoverageProblem problem = Problems.problem(targets, Problems.of(targets, masks));
    StepSolver solver = new StepSolver(Objective.parse(objective), problem, Solver.UNLIMITED);
    solver.solve();
    return solver;
  }

  private static void assertIsBest(
      Objective objective,
      int targets,
      boolean[][][] sets,
      CoverageProblem problem,
      StepSolver solver) {
    Problems.fill(problem, targets, sets);
    solver.solve();
    Exhaustive best = Exhaustive.solve(objective, targets, sets);
    assertTrue(solver.proven());
    assertEquals(best.score(), solver.score(), () -> Arrays.deepToString(sets));
    assertArrayEquals(
        best.configuration(), configuration(solver, sets), () -> Arrays.deepToString(sets));
  }

  private static int[] configuration(Solver solver, boolean[][][] sets) {
    int[] first = new int[sets.length];
    for (int camera = 1; camera < sets.length; camera++) {
      first[camera] = first[camera - 1] + sets[camera - 1].length;
    }
    return IntStream.range(0, sets.length)
        .map(camera -> solver.chosen(camera) - first[camera])
        .toArray();
  }
}
