package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ValueSolverTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "covered:k=1",
        "covered:k=2",
        "covered:k=3",
        "covered:k=99",
        "sum:cap=1",
        "sum:cap=2",
        "sum:cap=3",
        "sum:cap=99",
        "lexicographic"
      })
  void findsTheScoreAndThePreferredChoiceOfThousandsOfRandomProblems(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(1);
    CoverageProblem problem = new CoverageProblem(8, 40, 80);
    ValueSolver solver = new ValueSolver(objective, problem, CoverageSolver.UNLIMITED);
    for (int trial = 0; trial < 4_000; trial++) {
      boolean[][][] sets = random(random, random.nextInt(7), 4, random.nextInt(9));
      assertIsBest(objective, targets(sets, random.nextInt(3)), sets, problem, solver);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"covered:k=1", "covered:k=2", "sum:cap=2", "sum:cap=3", "lexicographic"})
  void findsThemWhereTargetsTakeSeveralWordsAndLevelsSeveralStages(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(2);
    CoverageProblem problem = new CoverageProblem(9, 40, 150);
    ValueSolver solver = new ValueSolver(objective, problem, CoverageSolver.UNLIMITED);
    for (int trial = 0; trial < 60; trial++) {
      boolean[][][] sets = random(random, 9, 2, 65 + random.nextInt(80));
      assertIsBest(objective, targets(sets, 0), sets, problem, solver);
    }
  }

  @Test
  void aLimitedSearchEnclosesTheBestScoreBetweenItsOwnAndItsBound() {
    SplittableRandom random = new SplittableRandom(3);
    int unproven = 0;
    for (int trial = 0; trial < 4_000; trial++) {
      String[] texts = {"covered:k=1", "covered:k=2", "sum:cap=2", "lexicographic"};
      Objective objective = Objective.parse(texts[trial % 4]);
      boolean[][][] sets = random(random, 6, 4, 8);
      CoverageProblem problem = new CoverageProblem(8, 40, 8);
      fill(problem, 8, sets);
      ValueSolver solver = new ValueSolver(objective, problem, trial % 3);
      solver.solve();
      double best = BestByObjective.of(objective, 8, sets).score();
      assertTrue(solver.value() <= best && best <= solver.bound());
      assertEquals(BestByObjective.score(objective, 8, sets, choice(solver, sets)), solver.value());
      assertTrue(!solver.proven() || solver.gap() == 0);
      unproven += solver.proven() ? 0 : 1;
    }
    assertTrue(unproven > 10, "no case in which the limit mattered");
  }

  @Test
  void kMinHasASolverOfItsOwn() {
    CoverageProblem problem = new CoverageProblem(1, 1, 1);
    assertInstanceOf(CoverageSolver.class, Solver.of(Objective.kMin(), problem, 1));
    assertInstanceOf(ValueSolver.class, Solver.of(Objective.parse("covered"), problem, 1));
  }

  @ParameterizedTest
  @ValueSource(strings = {"covered:k=1", "covered:k=2", "sum:cap=3", "lexicographic"})
  void allocatesNothingWhileItSolves(String text) {
    SplittableRandom random = new SplittableRandom(4);
    CoverageProblem problem = new CoverageProblem(9, 40, 70);
    ValueSolver solver = new ValueSolver(Objective.parse(text), problem, 10_000);
    fill(problem, 70, random(random, 9, 4, 70));
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(solver::solve)));
  }

  private static void assertIsBest(
      Objective objective,
      int targets,
      boolean[][][] sets,
      CoverageProblem problem,
      ValueSolver solver) {
    fill(problem, targets, sets);
    solver.solve();
    BestByObjective best = BestByObjective.of(objective, targets, sets);
    assertTrue(solver.proven());
    assertEquals(best.score(), solver.value(), () -> Arrays.deepToString(sets));
    assertArrayEquals(best.choice(), choice(solver, sets), () -> Arrays.deepToString(sets));
  }

  private static int targets(boolean[][][] sets, int none) {
    return sets.length == 0 ? none : sets[0][0].length;
  }

  private static boolean[][][] random(SplittableRandom random, int cameras, int most, int targets) {
    double density = random.nextDouble();
    boolean[][][] sets = new boolean[cameras][][];
    for (int camera = 0; camera < cameras; camera++) {
      sets[camera] = new boolean[1 + random.nextInt(most)][targets];
      for (boolean[] set : sets[camera]) {
        for (int target = 0; target < targets; target++) {
          set[target] = random.nextDouble() < density;
        }
      }
    }
    return sets;
  }

  private static void fill(CoverageProblem problem, int targets, boolean[][][] sets) {
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
  }

  private static int[] choice(Solver solver, boolean[][][] sets) {
    int[] choice = new int[sets.length];
    int first = 0;
    for (int camera = 0; camera < sets.length; camera++) {
      choice[camera] = solver.chosen(camera) - first;
      first += sets[camera].length;
    }
    return choice;
  }
}
