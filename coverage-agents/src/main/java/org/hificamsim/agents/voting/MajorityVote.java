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
  private final int[] votes; // by view

  MajorityVote(Draw draw, int views) {
    this.draw = draw;
    votes = new int[views];
  }

  /** Forgets all votes. */
  void open() {
    Arrays.fill(votes, 0);
  }

  void vote(int view) {
    votes[view]++;
  }

  /**
   * The view with most votes.
   *
   * @param own the camera's own action, which also wins where nobody voted
   */
  int winner(int own) {
    return switch (draw) {
      case OWN -> Ties.WIDEST.mostVotes(votes, votes[own], own);
      case WIDEST -> Ties.WIDEST.mostVotes(votes, 0, own);
      case NARROWEST -> Ties.NARROWEST.mostVotes(votes, 0, own);
    };
  }
}
