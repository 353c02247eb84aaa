package org.hificamsim.agents.voting;

import java.util.Arrays;

/** Counts votes for views and names the winner (thesis 7.4.5, majority voting). */
final class MajorityVote {
  private final VoteTies ties;
  private final int[] votes;

  MajorityVote(VoteTies ties, int views) {
    this.ties = ties;
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
    int winner = own;
    int most = ties == VoteTies.OWN ? votes[own] : 0;
    for (int i = 0; i < votes.length; i++) {
      int view = ties == VoteTies.NARROWEST ? i : votes.length - 1 - i;
      if (votes[view] > most) {
        winner = view;
        most = votes[view];
      }
    }
    return winner;
  }
}
