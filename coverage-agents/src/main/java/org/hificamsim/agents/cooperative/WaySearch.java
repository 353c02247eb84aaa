package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.solver.way.TravelTimes;

/**
 * Finds the best ways of a camera through its views up to the horizon, by dynamic programming over
 * steps and views (Bellman 1957): the worth of a view from a step on is its reward in that step
 * plus the worth of the best continuation. During a move the camera is blind and earns nothing.
 */
final class WaySearch {
  private static final double TIE = 1e-9;

  private final int horizon;
  private int views;
  private TravelTimes times;

  /** The reward of seeing through a view in a step, by step and view. */
  private double[] rewards = {};

  /** The worth of the best way that sees through the view in the step, by step and view. */
  private double[] values = {};

  /** The view that the best way chooses next, by step and view. */
  private int[] nextViews = {};

  /** The views, the best of a step first. */
  private int[] order = {};

  private final int[] way;

  /** What each move must add. */
  private double movePrice;

  WaySearch(int horizon) {
    this.horizon = horizon;
    way = new int[horizon];
  }

  /**
   * Begins a search.
   *
   * @param cameraTimes travel times between the camera's views
   * @return the rewards, all 0, to be filled in by step and view
   */
  double[] begin(TravelTimes cameraTimes) {
    times = cameraTimes;
    if (views != times.views()) {
      views = times.views();
      order = order.length < views ? new int[views] : order;
      Arrays.setAll(order, view -> view);
    }
    if (rewards.length < horizon * views) {
      rewards = new double[horizon * views];
      values = new double[horizon * views];
      nextViews = new int[horizon * views];
    }
    Arrays.fill(rewards, 0, horizon * views, 0);
    return rewards;
  }

  /**
   * Finds the best way from each view and step on.
   *
   * @param price what each move on a way must add, in the unit of the rewards; 0 or more
   */
  void solve(double price) {
    movePrice = price;
    int last = (horizon - 1) * views;
    for (int view = 0; view < views; view++) {
      values[last + view] = rewards[last + view];
      nextViews[last + view] = view;
    }
    for (int step = horizon - 2; step >= 0; step--) {
      sort(step + 1);
      for (int view = 0; view < views; view++) {
        solve(step, view);
      }
    }
  }

  /** Sorts the views by what they are worth from a step on, the best first. */
  private void sort(int step) {
    int first = step * views;
    for (int i = 1; i < views; i++) {
      int view = order[i];
      double value = values[first + view];
      int index = i;
      while (index > 0 && values[first + order[index - 1]] < value) {
        order[index] = order[index - 1];
        index--;
      }
      order[index] = view;
    }
  }

  /**
   * Chooses the view after this one. A view is never worth more if it is reached later, so the
   * search ends at the first view that would not be worth enough even if it were reached at once.
   */
  private void solve(int step, int view) {
    int state = step * views + view;
    int following = (step + 1) * views;
    int best = view;
    double bestValue = values[following + view];
    for (int i = 0; i < views && values[following + order[i]] > enough(bestValue); i++) {
      int next = order[i];
      int arrival = step + 1 + times.blindSteps(view, next);
      if (arrival < horizon && values[arrival * views + next] > enough(bestValue)) {
        best = next;
        bestValue = values[arrival * views + next] - movePrice;
      }
    }
    nextViews[state] = best;
    values[state] = rewards[state] + bestValue;
  }

  /** What a view must be worth for a move to it to add more than a value. */
  private double enough(double value) {
    return value + movePrice + TIE;
  }

  /** The worth of the best way that sees through a view after some steps; 0 past the horizon. */
  double value(int delay, int view) {
    return delay < horizon ? values[delay * views + view] : 0;
  }

  /**
   * Returns the best way that sees through a view after some steps, as in {@link Ways}. The next
   * call overwrites the array.
   */
  int[] way(int delay, int view) {
    int goal = view;
    int arrival = delay;
    for (int step = 0; step < horizon; step++) {
      way[step] = step < arrival ? ~goal : goal;
      if (step == arrival) {
        int next = nextViews[step * views + goal];
        arrival = step + 1 + times.blindSteps(goal, next);
        goal = next;
      }
    }
    return way;
  }
}
