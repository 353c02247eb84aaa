package org.hificamsim.agents.voting;

import org.hificamsim.core.registry.Options;

/**
 * Who votes on a camera's next view and what a draw does.
 *
 * @param neighbours the number k of nearest cameras that are asked, 0 or more; not published
 * @param ownVote whether the camera's own best action counts as a vote
 */
public record VoteSettings(int neighbours, OwnVote ownVote, VoteTies ties) {
  private static final int MAX_NEIGHBOURS = 10_000;

  /** Whether a camera votes on its own next view; thesis 7.4.5 says that it does. */
  public enum OwnVote {
    YES,
    NO
  }

  /** The options {@code k}, {@code own-vote} and {@code vote-ties}. */
  public static VoteSettings from(Options options) {
    return new VoteSettings(
        options.integer("k", 4, 0, MAX_NEIGHBOURS, "number of nearest cameras that are asked"),
        options.choice("own-vote", OwnVote.YES, "whether the own best action counts: yes, no"),
        options.choice(
            "vote-ties", VoteTies.OWN, "who wins a draw: own (else widest), widest, narrowest"));
  }
}
