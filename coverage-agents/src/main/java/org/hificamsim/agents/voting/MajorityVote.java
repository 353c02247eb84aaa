package org.hificamsim.agents.voting;

import java.util.Arrays;

/** Counts votes for levels and names the winner (section 7.4.5, majority voting). */
final class MajorityVote {
  /** Enough for any camera's levels. */
  private static final int LEVEL_BITS = 20;

  private static final int LEVEL = (1 << LEVEL_BITS) - 1;

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
    long most = ballot(0, votes.length, own);
    for (int level = 0; level < votes.length; level++) {
      most = Math.max(most, ballot(votes[level], rank(level, own), level));
    }
    return (int) most & LEVEL;
  }

  /** A number that is larger for more votes, then for a higher rank; its low bits are the level. */
  private static long ballot(int votes, int rank, int level) {
    return ((long) votes << (2 * LEVEL_BITS)) | ((long) rank << LEVEL_BITS) | level;
  }

  /** Which of two levels with equally many votes wins: the one of higher rank. */
  private int rank(int level, int own) {
    if (ties == VoteTies.NARROWEST) {
      return votes.length - 1 - level;
    }
    return ties == VoteTies.OWN && level == own ? votes.length : level;
  }
}
