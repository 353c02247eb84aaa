package org.hificamsim.solver.way;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

class WaySolverTest {
  private static final String[] OBJECTIVES = {
    "covered:k=1", "covered:k=2", "kmin", "sum:cap=2", "lexicographic"
  };

  private static final double ROUNDING = 1e-6;

  private static RandomWays ways(int number) {
    return new RandomWays(number, Objective.parse(OBJECTIVES[number % OBJECTIVES.length]));
  }

  @RepeatedTest(100)
  void boundAndPlanEncloseTheBestOfAllWays(RepetitionInfo repetition) {
    RandomWays ways = ways(repetition.getCurrentRepetition());
    WaySolver solver = new WaySolver(ways.problem);
    solver.solve(100);
    double best = ways.bestOfAll();
    assertTrue(solver.score() <= best, () -> solver.score() + " > " + best);
    assertTrue(solver.bound() >= best, () -> solver.bound() + " < " + best);
    assertTrue(solver.bound() <= ways.bestOfJumps() + ROUNDING);
    assertEquals(solver.score(), ways.score(solver));
  }

  @RepeatedTest(20)
  void anyPricesGiveABound(RepetitionInfo repetition) {
    RandomWays ways = ways(repetition.getCurrentRepetition());
    SplittableRandom random = new SplittableRandom(repetition.getCurrentRepetition());
    double[] prices = random.doubles(ways.problem.sets(), 0, 1).toArray();
    assertTrue(new WaySolver(ways.problem).boundBy(prices) >= ways.bestOfAll());
  }

  @RepeatedTest(10)
  void boundCanBeComputedAgainFromPrices(RepetitionInfo repetition) {
    RandomWays ways = ways(repetition.getCurrentRepetition());
    WaySolver solver = new WaySolver(ways.problem);
    solver.solve(50);
    double again = new WaySolver(ways.problem).boundBy(solver.prices());
    assertTrue(
        Math.floor(again) <= solver.bound() + ROUNDING || again <= solver.bound() + ROUNDING);
  }

  @Test
  void closesTheGapOfMostSmallProblems() {
    int closed = 0;
    for (int number = 0; number < 100; number++) {
      RandomWays ways = ways(number);
      WaySolver solver = new WaySolver(ways.problem);
      solver.solve(200);
      closed += solver.bound() - solver.score() < 0.01 ? 1 : 0;
    }
    assertTrue(closed >= 90, closed + " of 100");
  }

  @Test
  void sameIterationsGiveSamePlanAndBound() {
    WaySolver first = new WaySolver(ways(3).problem);
    WaySolver second = new WaySolver(ways(3).problem);
    first.solve(30);
    second.solve(30);
    assertEquals(first.bound(), second.bound());
    assertArrayEquals(first.prices(), second.prices());
    assertArrayEquals(first.goals(0), second.goals(0));
  }
}
