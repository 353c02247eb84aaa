package org.hificamsim.agents.voting;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class MajorityVoteTest {
  @Test
  void mostVotesWinAgainstTheOwnAction() {
    assertEquals(3, winner(MajorityVote.Draw.OWN, 0, 0, 3, 3));
  }

  @Test
  void theOwnActionWinsADrawItTakesPartIn() {
    assertEquals(1, winner(MajorityVote.Draw.OWN, 1, 1, 3));
  }

  @Test
  void theWidestWinsADrawWithoutTheOwnAction() {
    assertEquals(3, winner(MajorityVote.Draw.OWN, 0, 0, 1, 1, 3, 3));
  }

  @Test
  void drawsGoToTheWidestOrNarrowestWhenSaidSo() {
    assertEquals(3, winner(MajorityVote.Draw.WIDEST, 1, 1, 3));
    assertEquals(1, winner(MajorityVote.Draw.NARROWEST, 3, 1, 3));
  }

  @Test
  void withoutVotesTheOwnActionStands() {
    for (MajorityVote.Draw ties : MajorityVote.Draw.values()) {
      assertEquals(2, winner(ties, 2));
    }
  }

  @Test
  void aSecondVoteForgetsTheFirst() {
    MajorityVote vote = new MajorityVote(MajorityVote.Draw.OWN, 4);
    vote.vote(3);
    vote.open();
    vote.vote(1);
    assertEquals(1, vote.winner(0));
  }

  private static int winner(MajorityVote.Draw ties, int own, int... votes) {
    MajorityVote vote = new MajorityVote(ties, 4);
    vote.open();
    for (int view : votes) {
      vote.vote(view);
    }
    return vote.winner(own);
  }
}
