package org.hificamsim.agents.voting;

import java.util.Arrays;
import org.hificamsim.agents.choice.Ties;

/** Counts votes for views and names the winner (thesis 7.4.5, majority voting). */
final class MajorityVote {
  /** Which of the views with most votes wins; thesis 7.4.5 does not say. */
  enum Draw {
    /** The camera's own action where it is among them, else the widest. */
    OWN,
    WIDEST,
    NARROWEST
  }

  private final Draw draw;
  private final double[] votes; // by view
  private int count;

  MajorityVote(Draw draw, int views) {
    this.draw = draw;
    votes = new double[views];
  }

  /** Forgets all votes. */
  void open() {
    Arrays.fill(votes, 0);
    count = 0;
  }

  void vote(int view) {
    votes[view]++;
    count++;
  }

  /**
   * The view with most votes.
   *
   * @param own the camera's own action, which also wins where nobody voted
   */
  int winner(int own) {
    if (count == 0 || 2 * votes[own] > count) {
      return own; // nobody voted, or more than half agree: the usual case, and no draw
    }
    return switch (draw) {
      case OWN -> Ties.WIDEST.best(votes, 0, votes.length, own);
      case WIDEST -> Ties.WIDEST.best(votes, 0, votes.length);
      case NARROWEST -> Ties.NARROWEST.best(votes, 0, votes.length);
    };
  }
}
