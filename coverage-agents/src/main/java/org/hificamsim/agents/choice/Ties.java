package org.hificamsim.agents.choice;

import org.hificamsim.core.registry.Options;

/**
 * Which of several equally good views a camera takes; the thesis does not say. All learners and
 * votes ask here.
 */
public enum Ties {
  WIDEST,
  NARROWEST;

  /** The option {@code ties}. */
  public static Ties from(Options options) {
    return options.choice("ties", WIDEST, "which of equally good views: widest, narrowest");
  }

  /** The view to take where all are equally good. */
  public int best(int views) {
    return this == WIDEST ? views - 1 : 0;
  }

  /**
   * The view with the largest value.
   *
   * @param values holds the value of view l at {@code from + l}; infinite values are allowed, NaN
   *     is not
   * @param views the number of views, 1 or more
   */
  public int best(double[] values, int from, int views) {
    int best = 0;
    double most = values[from];
    for (int view = 1; view < views; view++) {
      double value = values[from + view];
      boolean better = value > most || (value == most && this == WIDEST);
      best = better ? view : best;
      most = better ? value : most;
    }
    return best;
  }

  /** The view with the largest value: of several this one, where it is among them. */
  public int best(double[] values, int from, int views, int preferred) {
    int best = best(values, from, views);
    return values[from + preferred] == values[from + best] ? preferred : best;
  }

  /** The view with most votes, if these are more than {@code least}; else {@code otherwise}. */
  public int mostVotes(int[] votes, int least, int otherwise) {
    int most = least;
    int winner = otherwise;
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
