package org.hificamsim.agents.voting;

import java.util.Arrays;

/** Counts votes for levels and names the winner (section 7.4.5, majority voting). */
final class MajorityVote {
  private final VoteTies ties;
  private final int[] votes;

  MajorityVote(VoteTies ties, int mostLevels) {
    this.ties = ties;
    votes = new int[mostLevels];
  }

  /** Forgets all votes. */
  void open() {
    Arrays.fill(votes, 0);
  }

  void vote(int level) {
    votes[level]++;
  }

  /**
   * The level with most votes.
   *
   * @param own the camera's own action, which also wins where nobody voted
   */
  int winner(int own) {
    int most = 0;
    int winner = own;
    for (int level = 0; level < votes.length; level++) {
      boolean tied = votes[level] == most && most > 0;
      if (votes[level] > most || (tied && ties != VoteTies.NARROWEST)) {
        most = votes[level];
        winner = level;
      }
    }
    return ties == VoteTies.OWN && votes[own] == most ? own : winner;
  }
}
