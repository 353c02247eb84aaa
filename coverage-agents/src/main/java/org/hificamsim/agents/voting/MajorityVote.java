package org.hificamsim.agents.voting;

import java.util.Arrays;
import org.hificamsim.agents.choice.Ties;

/** Counts votes for views and names the winner (thesis 7.4.5, majority voting). */
final class MajorityVote {
  private final VoteTies ties;
  private final double[] votes; // by view
  private int count;

  MajorityVote(VoteTies ties, int views) {
    this.ties = ties;
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
    if (count == 0) {
      return own;
    }
    return switch (ties) {
      case OWN -> Ties.WIDEST.best(votes, 0, votes.length, own);
      case WIDEST -> Ties.WIDEST.best(votes, 0, votes.length);
      case NARROWEST -> Ties.NARROWEST.best(votes, 0, votes.length);
    };
  }
}
