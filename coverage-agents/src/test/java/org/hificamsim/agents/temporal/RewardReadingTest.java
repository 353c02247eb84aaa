package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RewardReadingTest {
  @Test
  void countChangeIsTheDifference() {
    assertRewards(RewardReading.COUNT_CHANGE, 3, 0, -3);
  }

  @Test
  void signIsTheSignOfTheDifference() {
    assertRewards(RewardReading.SIGN, 1, 0, -1);
  }

  @Test
  void literalRewardOfLosingAllTargetsIsZero() {
    assertRewards(RewardReading.LITERAL, 5, 0, -2);
    assertEquals(0, RewardReading.LITERAL.reward(4, 0), 0);
  }

  private static void assertRewards(
      RewardReading reading, double rising, double same, double falling) {
    assertEquals(rising, reading.reward(2, 5), 0);
    assertEquals(same, reading.reward(5, 5), 0);
    assertEquals(falling, reading.reward(5, 2), 0);
  }
}
