package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CoverageSolverTest {
  @Test
  void findsTheValueAndThePreferredChoiceOfThousandsOfRandomProblems() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 20_000; trial++) {
      int targets = 1 + random.nextInt(7);
      long[][] sets = randomSets(random, 1 + random.nextInt(7), 4, targets, random.nextDouble());
      CoverageSolver solver = solve(targets, sets);
      Exhaustive best = Exhaustive.solve(targets, sets);
      assertEquals(best.value(), solver.value(), () -> "trial " + Exhaustive.text(sets));
      assertArrayEquals(
          best.choice(), choice(solver, sets), () -> "trial " + Exhaustive.text(sets));
      assertTrue(solver.proven());
    }
  }

  @Test
  void findsTheOptimumOfProblemsThatBoundsAloneDoNotSettle() {
    SplittableRandom random = new SplittableRandom(2);
    long nodes = 0;
    for (int trial = 0; trial < 300; trial++) {
      long[][] sets = randomSets(random, 9, 3, 12, 0.4);
      CoverageSolver solver = solve(12, sets);
      nodes += solver.nodes();
      assertEquals(Exhaustive.solve(12, sets).value(), solver.value());
    }
    assertTrue(nodes > 900, "searched only " + nodes + " nodes");
  }

  @Test
  void coversMoreTargetsThanOneWordHolds() {
    SplittableRandom random = new SplittableRandom(3);
    for (int trial = 0; trial < 300; trial++) {
      int targets = 60 + random.nextInt(90);
      boolean[][][] sets = new boolean[6][3][targets];
      for (boolean[][] camera : sets) {
        for (boolean[] set : camera) {
          for (int target = 0; target < targets; target++) {
            set[target] = random.nextInt(8) > 0;
          }
        }
      }
      CoverageSolver solver = new CoverageSolver(problem(targets, sets), CoverageSolver.UNLIMITED);
      solver.solve();
      assertEquals(Exhaustive.value(targets, sets), solver.value());
    }
  }

  @Test
  void withoutTargetsEveryCameraTakesItsFirstSet() {
    CoverageSolver solver = solve(0, new long[][] {{0, 0}, {0}});
    assertEquals(0, solver.chosen(0));
    assertEquals(2, solver.chosen(1));
    assertTrue(solver.proven());
  }

  @Test
  void withoutCamerasNothingIsCovered() {
    CoverageSolver solver = solve(3, new long[][] {});
    assertEquals(0, solver.value());
    assertTrue(solver.proven());
  }

  @Test
  void aTargetOutOfReachLeavesEveryCameraItsPreference() {
    CoverageSolver solver = solve(2, new long[][] {{0, 1}, {1, 0}});
    assertEquals(0, solver.value());
    assertArrayEquals(new int[] {0, 0}, choice(solver, new long[][] {{0, 1}, {1, 0}}));
  }

  @Test
  void theSameSolverSolvesProblemsOfDifferentSizesInTurn() {
    CoverageProblem problem = new CoverageProblem(8, 32, 100);
    CoverageSolver solver = new CoverageSolver(problem, CoverageSolver.UNLIMITED);
    SplittableRandom random = new SplittableRandom(4);
    for (int trial = 0; trial < 2_000; trial++) {
      int targets = random.nextInt(7);
      long[][] sets = randomSets(random, 1 + random.nextInt(5), 3, targets, 0.5);
      fill(problem, targets, sets);
      solver.solve();
      assertEquals(Exhaustive.solve(targets, sets).value(), solver.value());
    }
  }

  private static CoverageSolver solve(int targets, long[][] sets) {
    CoverageProblem problem = new CoverageProblem(sets.length, 100, targets);
    fill(problem, targets, sets);
    CoverageSolver solver = new CoverageSolver(problem, CoverageSolver.UNLIMITED);
    solver.solve();
    return solver;
  }

  private static void fill(CoverageProblem problem, int targets, long[][] sets) {
    problem.clear(targets);
    for (long[] camera : sets) {
      problem.addCamera();
      for (int set = 0; set < camera.length; set++) {
        problem.addSet(camera, set);
      }
    }
  }

  private static CoverageProblem problem(int targets, boolean[][][] sets) {
    CoverageProblem problem = new CoverageProblem(sets.length, 100, targets);
    problem.clear(targets);
    for (boolean[][] camera : sets) {
      problem.addCamera();
      for (boolean[] set : camera) {
        long[] mask = new long[CoverageProblem.wordsFor(targets)];
        for (int target = 0; target < targets; target++) {
          mask[target / 64] |= set[target] ? 1L << (target % 64) : 0;
        }
        problem.addSet(mask, 0);
      }
    }
    return problem;
  }

  private static int[] choice(CoverageSolver solver, long[][] sets) {
    int[] choice = new int[sets.length];
    int first = 0;
    for (int camera = 0; camera < sets.length; camera++) {
      choice[camera] = solver.chosen(camera) - first;
      first += sets[camera].length;
    }
    return choice;
  }

  private static long[][] randomSets(
      SplittableRandom random, int cameras, int most, int targets, double density) {
    long[][] sets = new long[cameras][];
    for (int camera = 0; camera < cameras; camera++) {
      sets[camera] = new long[1 + random.nextInt(most)];
      for (int set = 0; set < sets[camera].length; set++) {
        for (int target = 0; target < targets; target++) {
          sets[camera][set] |= random.nextDouble() < density ? 1L << target : 0;
        }
      }
    }
    return sets;
  }
}
