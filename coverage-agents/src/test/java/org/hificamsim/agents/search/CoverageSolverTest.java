package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class CoverageSolverTest {
  @Test
  void findsTheValueAndThePreferredChoiceOfThousandsOfRandomProblems() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 20_000; trial++) {
      int targets = 1 + random.nextInt(7);
      int cameras = 1 + random.nextInt(7);
      long[][] sets = Problems.random(random, cameras, 4, targets, random.nextDouble());
      CoverageSolver solver = solve(targets, sets);
      Exhaustive best = Exhaustive.solve(targets, sets);
      assertEquals(best.value(), solver.value(), () -> Exhaustive.text(sets));
      assertArrayEquals(best.choice(), choice(solver, sets), () -> Exhaustive.text(sets));
      assertTrue(solver.proven());
    }
  }

  @Test
  void findsTheValueAndThePreferredChoiceOfLargerProblems() {
    SplittableRandom random = new SplittableRandom(2);
    for (int trial = 0; trial < 300; trial++) {
      long[][] sets = Problems.random(random, 9, 3, 12, 0.4);
      CoverageSolver solver = solve(12, sets);
      Exhaustive best = Exhaustive.solve(12, sets);
      assertEquals(best.value(), solver.value());
      assertArrayEquals(best.choice(), choice(solver, sets));
    }
  }

  @Test
  void searchesNothingWhereEachCameraHasASetThatHoldsItsOthers() {
    SplittableRandom random = new SplittableRandom(8);
    for (int trial = 0; trial < 5_000; trial++) {
      int targets = 1 + random.nextInt(10);
      long[][] sets = Problems.random(random, 1 + random.nextInt(6), 4, targets, 0.6);
      for (long[] camera : sets) {
        camera[random.nextInt(camera.length)] = Arrays.stream(camera).reduce(0, (a, b) -> a | b);
      }
      CoverageSolver solver = solve(targets, sets);
      Exhaustive best = Exhaustive.solve(targets, sets);
      assertEquals(best.value(), solver.value(), () -> Exhaustive.text(sets));
      assertArrayEquals(best.choice(), choice(solver, sets), () -> Exhaustive.text(sets));
      assertEquals(0, solver.nodes());
      assertTrue(solver.proven());
    }
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
    long[][] sets = {{0, 1}, {1, 0}};
    CoverageSolver solver = solve(2, sets);
    assertEquals(0, solver.value());
    assertArrayEquals(new int[] {0, 0}, choice(solver, sets));
  }

  @Test
  void theSameSolverSolvesProblemsOfDifferentSizesInTurn() {
    CoverageProblem problem = new CoverageProblem(8, 32, 100);
    CoverageSolver solver = new CoverageSolver(problem, CoverageSolver.UNLIMITED);
    SplittableRandom random = new SplittableRandom(4);
    for (int trial = 0; trial < 2_000; trial++) {
      int targets = random.nextInt(7);
      long[][] sets = Problems.random(random, 1 + random.nextInt(5), 3, targets, 0.5);
      Problems.fill(problem, targets, sets);
      solver.solve();
      Exhaustive best = Exhaustive.solve(targets, sets);
      assertEquals(best.value(), solver.value());
      assertArrayEquals(best.choice(), choice(solver, sets));
    }
  }

  @Test
  void aLimitedSearchEnclosesTheOptimumBetweenItsValueAndItsBound() {
    SplittableRandom random = new SplittableRandom(5);
    int unproven = 0;
    for (int trial = 0; trial < 3_000; trial++) {
      long[][] sets = Problems.random(random, 7, 4, 8, 0.4);
      CoverageSolver solver = new CoverageSolver(Problems.problem(8, sets), trial % 2);
      solver.solve();
      int best = Exhaustive.solve(8, sets).value();
      assertTrue(solver.value() <= best && best <= solver.bound());
      assertEquals(solver.value(), Exhaustive.value(8, sets, choice(solver, sets)));
      assertTrue(solver.nodes() <= 1 + 28L * PreferredChoice.MAX_NODES);
      unproven += solver.proven() ? 0 : 1;
    }
    assertTrue(unproven > 0, "no case in which the limit mattered");
  }

  @Test
  void eachCallHasTheWholeLimitAndCountsItsOwnNodes() {
    SplittableRandom random = new SplittableRandom(7);
    int searched = 0;
    for (int trial = 0; trial < 300; trial++) {
      long[][] sets = Problems.random(random, 7, 4, 8, 0.4);
      CoverageSolver solver = new CoverageSolver(Problems.problem(8, sets), 2);
      solver.solve();
      long nodes = solver.nodes();
      int bound = solver.bound();
      int[] choice = choice(solver, sets);
      solver.solve();
      assertEquals(nodes, solver.nodes());
      assertEquals(bound, solver.bound());
      assertArrayEquals(choice, choice(solver, sets));
      searched += nodes > 0 ? 1 : 0;
    }
    assertTrue(searched > 0, "no case that is searched");
  }

  @Test
  void provesANetworkOfTwoHundredCameras() {
    SplittableRandom random = new SplittableRandom(6);
    boolean[][][] sets = new boolean[200][5][40];
    for (boolean[][] camera : sets) {
      int around = random.nextInt(40);
      for (boolean[] set : camera) {
        for (int target = around; target < around + 6; target++) {
          set[target % 40] = random.nextBoolean();
        }
      }
    }
    CoverageSolver solver = new CoverageSolver(problem(40, sets), 100_000);
    solver.solve();
    assertTrue(solver.proven(), solver.value() + " to " + solver.bound());
    assertTrue(solver.value() > 10, "covered " + solver.value() + " times");
  }

  private static CoverageSolver solve(int targets, long[][] sets) {
    CoverageSolver solver =
        new CoverageSolver(Problems.problem(targets, sets), CoverageSolver.UNLIMITED);
    solver.solve();
    return solver;
  }

  private static CoverageProblem problem(int targets, boolean[][][] sets) {
    CoverageProblem problem = new CoverageProblem(sets.length, 1_000, targets);
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
}
