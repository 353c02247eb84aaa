package org.hificamsim.agents.voting;

import java.util.Arrays;
import org.hificamsim.agents.choice.Ties;

/** Counts votes for views, and determines the winner (majority voting of thesis 7.4.5). */
final class MajorityVote {
  /** The choice among views with equally many votes; thesis 7.4.5 leaves this open. */
  enum DrawRule {
    /** The camera's own best view if it is one of them, else the widest. */
    OWN,
    WIDEST,
    NARROWEST
  }

  private final DrawRule drawRule;
  private final int[] votes;

  MajorityVote(DrawRule drawRule, int views) {
    this.drawRule = drawRule;
    votes = new int[views];
  }

  /** Removes all votes. */
  void clear() {
    Arrays.fill(votes, 0);
  }

  /** Adds a vote for a view. */
  void vote(int view) {
    votes[view]++;
  }

  /**
   * Returns the view with most votes.
   *
   * @param own the camera's own best view, which wins if there is no vote
   */
  int winner(int own) {
    return switch (drawRule) {
      case OWN -> Ties.WIDEST.mostVotes(votes, votes[own], own);
      case WIDEST -> Ties.WIDEST.mostVotes(votes, 0, own);
      case NARROWEST -> Ties.NARROWEST.mostVotes(votes, 0, own);
    };
  }
}
