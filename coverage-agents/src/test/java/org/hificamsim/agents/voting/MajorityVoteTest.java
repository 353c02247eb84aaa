package org.hificamsim.agents.voting;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class MajorityVoteTest {
  @Test
  void mostVotesWinAgainstTheOwnView() {
    assertEquals(3, winner(MajorityVote.DrawRule.OWN, 0, 0, 3, 3));
  }

  @Test
  void ownViewWinsADrawThatIncludesIt() {
    assertEquals(1, winner(MajorityVote.DrawRule.OWN, 1, 1, 3));
  }

  @Test
  void widestViewWinsADrawWithoutTheOwnView() {
    assertEquals(3, winner(MajorityVote.DrawRule.OWN, 0, 0, 1, 1, 3, 3));
  }

  @Test
  void drawRuleDecidesForWidestOrNarrowest() {
    assertEquals(3, winner(MajorityVote.DrawRule.WIDEST, 1, 1, 3));
    assertEquals(1, winner(MajorityVote.DrawRule.NARROWEST, 3, 1, 3));
  }

  @Test
  void ownViewWinsWithoutVotes() {
    for (MajorityVote.DrawRule drawRule : MajorityVote.DrawRule.values()) {
      assertEquals(2, winner(drawRule, 2));
    }
  }

  @Test
  void clearRemovesAllVotes() {
    MajorityVote vote = new MajorityVote(MajorityVote.DrawRule.OWN, 4);
    vote.vote(3);
    vote.clear();
    vote.vote(1);
    assertEquals(1, vote.winner(0));
  }

  private static int winner(MajorityVote.DrawRule drawRule, int own, int... votes) {
    MajorityVote vote = new MajorityVote(drawRule, 4);
    vote.clear();
    for (int view : votes) {
      vote.vote(view);
    }
    return vote.winner(own);
  }
}
