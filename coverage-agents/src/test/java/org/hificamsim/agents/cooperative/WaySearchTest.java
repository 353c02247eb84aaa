package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.solver.way.TravelTimes;
import org.junit.jupiter.api.Test;

class WaySearchTest {
  private static final int HORIZON = 4;
  private static final int VIEWS = 3;

  private final SplittableRandom random = new SplittableRandom(5);
  private final WaySearch search = new WaySearch(HORIZON);
  private double movePrice;

  @Test
  void findsTheBestOfAllWays() {
    for (int trial = 0; trial < 500; trial++) {
      int[] moveTimes = moveTimes();
      double[] rewards = search.begin(new TravelTimes(0, VIEWS, moveTimes));
      for (int i = 0; i < HORIZON * VIEWS; i++) {
        rewards[i] = random.nextInt(4) == 0 ? random.nextDouble() : 0;
      }
      movePrice = trial % 3 * 0.3;
      search.solve(movePrice);
      for (int view = 0; view < VIEWS; view++) {
        double best = best(rewards, moveTimes, trial % 2, view);
        assertEquals(best, search.value(trial % 2, view), 1e-6, "trial " + trial);
        assertEquals(best, worth(rewards, search.way(trial % 2, view)), 1e-6, "trial " + trial);
      }
    }
  }

  private int[] moveTimes() {
    int[] positions = random.ints(VIEWS, 0, 4).toArray();
    int[] times = new int[VIEWS * VIEWS];
    Arrays.setAll(
        times,
        pair -> Math.max(0, Math.abs(positions[pair / VIEWS] - positions[pair % VIEWS]) - 1));
    return times;
  }

  private double best(double[] rewards, int[] moveTimes, int step, int view) {
    if (step >= HORIZON) {
      return 0;
    }
    double after = 0;
    for (int next = 0; next < VIEWS; next++) {
      int arrival = step + 1 + moveTimes[view * VIEWS + next];
      double price = next == view ? 0 : movePrice;
      after = Math.max(after, best(rewards, moveTimes, arrival, next) - price);
    }
    return rewards[step * VIEWS + view] + after;
  }

  private double worth(double[] rewards, int[] way) {
    double sum = 0;
    for (int step = 0; step < HORIZON; step++) {
      sum += way[step] >= 0 ? rewards[step * VIEWS + way[step]] : 0;
      boolean sameGoal = step == 0 || Ways.goal(way, step) == Ways.goal(way, step - 1);
      sum -= sameGoal ? 0 : movePrice;
    }
    return sum;
  }

  @Test
  void staysWhenNoOtherViewIsWorthMore() {
    search.begin(new TravelTimes(0, VIEWS, new int[VIEWS * VIEWS]));
    search.solve(0);
    assertArrayEquals(new int[] {~2, 2, 2, 2}, search.way(1, 2));
  }

  @Test
  void continuesWaysOfEarlierSteps() {
    int[] rest = new int[4];
    Ways.after(new int[] {1, ~4, ~4, 4}, 2, 5, rest);
    assertArrayEquals(new int[] {~4, 4, 4, 4}, rest);
    Ways.after(new int[] {1, 1, 1, ~4}, 3, 3, rest);
    assertArrayEquals(new int[] {~2, 2, 2, 2}, rest);
  }
}
