package org.hificamsim.agents.choice;

import org.hificamsim.core.registry.Options;

/** The choice among equally good views, for all learners and votes. */
public enum Ties {
  WIDEST,
  NARROWEST;

  /** Reads the option {@code ties}. The thesis leaves this open. */
  public static Ties from(Options options) {
    return options.choice("ties", WIDEST, "which of equally good views: widest, narrowest");
  }

  /** Returns the view to take when all are equally good. */
  public int best(int views) {
    return this == WIDEST ? views - 1 : 0;
  }

  /**
   * Returns the view with the greatest value.
   *
   * @param values the value of view i at index {@code from + i}; may be infinite, but not NaN
   * @param views number of views, 1 or more
   */
  public int best(double[] values, int from, int views) {
    int best = 0;
    double greatest = values[from];
    for (int view = 1; view < views; view++) {
      double value = values[from + view];
      boolean better = value > greatest || (value == greatest && this == WIDEST);
      best = better ? view : best;
      greatest = better ? value : greatest;
    }
    return best;
  }

  /** Returns the view with the greatest value, {@code preferred} if it is one of several. */
  public int best(double[] values, int from, int views, int preferred) {
    int best = best(values, from, views);
    return values[from + preferred] == values[from + best] ? preferred : best;
  }

  /**
   * Returns the view with most votes.
   *
   * @param fallback the view to return if no view has more than {@code minimum} votes
   */
  public int mostVotes(int[] votes, int minimum, int fallback) {
    int most = minimum;
    int winner = fallback;
    for (int i = 0; i < votes.length; i++) {
      int view = this == NARROWEST ? i : votes.length - 1 - i;
      if (votes[view] > most) {
        winner = view;
        most = votes[view];
      }
    }
    return winner;
  }
}
