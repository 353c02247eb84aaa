package org.hificamsim.solver.configuration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BoundSolverTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "kmin",
        "covered:k=1",
        "covered:k=2",
        "covered:k=3",
        "sum:cap=1",
        "sum:cap=2",
        "sum:cap=99",
        "lexicographic"
      })
  void boundIsNeverBelowTheBestScore(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(1);
    CoverageProblem problem = new CoverageProblem(8, 40, 80);
    BoundSolver solver = new BoundSolver(objective, problem);
    for (int trial = 0; trial < 2_000; trial++) {
      int targets = 1 + random.nextInt(9);
      double density = random.nextDouble();
      boolean[][][] sets = Problems.random(random, random.nextInt(7), 4, targets, density);
      Problems.fill(problem, targets, sets);
      solver.solve();
      double best = Exhaustive.solve(objective, targets, sets).score();
      double score = Exhaustive.score(objective, targets, sets, configuration(solver, sets));
      assertTrue(score + solver.gap() >= best, () -> Arrays.deepToString(sets));
      assertTrue(!solver.proven() || score == best, () -> Arrays.deepToString(sets));
      assertEquals(solver.proven(), solver.gap() == 0);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=2", "lexicographic"})
  void boundIsCloseWhenManyCamerasShareTargets(String text) {
    Objective objective = Objective.parse(text);
    SplittableRandom random = new SplittableRandom(2);
    double optima = 0;
    double bounds = 0;
    for (int trial = 0; trial < 20; trial++) {
      boolean[][][] sets = Problems.random(random, 10, 6, 70, 0.2);
      CoverageProblem problem = Problems.problem(70, sets);
      StepSolver exact = new StepSolver(objective, problem, 100_000);
      exact.solve();
      BoundSolver solver = new BoundSolver(objective, problem);
      solver.solve();
      double bound =
          Exhaustive.score(objective, 70, sets, configuration(solver, sets)) + solver.gap();
      assertTrue(bound >= exact.score());
      optima += exact.score();
      bounds += bound;
    }
    assertTrue(bounds <= 1.15 * optima + 20, bounds + " where " + optima + " is possible");
  }

  @Test
  void sumsOfScoresAndGapsBoundTheSumOfOptima() {
    Objective objective = Objective.parse("covered:k=1");
    SplittableRandom random = new SplittableRandom(3);
    double optima = 0;
    double scores = 0;
    double gaps = 0;
    for (int trial = 0; trial < 3_000; trial++) {
      boolean[][][] sets = Problems.random(random, 4, 3, 13, 0.3);
      BoundSolver solver = new BoundSolver(objective, Problems.problem(13, sets));
      solver.solve();
      optima += Exhaustive.solve(objective, 13, sets).score();
      scores += Exhaustive.score(objective, 13, sets, configuration(solver, sets));
      gaps += solver.gap();
      assertTrue(scores + gaps >= optima, "after " + trial);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "sum:cap=3", "lexicographic"})
  void allocatesNothingWhileItSolves(String text) {
    boolean[][][] sets = Problems.random(new SplittableRandom(4), 9, 4, 70, 0.3);
    BoundSolver solver = new BoundSolver(Objective.parse(text), Problems.problem(70, sets));
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(solver::solve)));
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
