package org.hificamsim.runs.benchmark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.hificamsim.runs.benchmark.Verification.Finding;
import org.junit.jupiter.api.Test;

class ClaimTest {
  private static double[] scores(Random random, double mean) {
    return random.doubles(10).map(value -> mean + 0.2 * value).toArray();
  }

  @Test
  void shareAlphaOfDifferencesExceedsMargin() {
    Random random = new Random(1);
    int exceeded = 0;
    for (int i = 0; i < 4_000; i++) {
      Claim claim = Claim.of(scores(random, 0.5), scores(random, 0.5));
      exceeded += Math.abs(claim.difference()) > claim.margin(0.05) ? 1 : 0;
    }
    assertEquals(200, exceeded, 45);
  }

  @Test
  void rejectsScoreHigherThanOnFreshSeeds() {
    Random random = new Random(1);
    Claim claim = Claim.of(scores(random, 0.6), scores(random, 0.3));
    double fresh = 0.4;
    assertFalse(new Finding(fresh + claim.difference(), fresh, claim.margin(0.05), true).holds());
    assertTrue(new Finding(fresh - claim.difference(), fresh, claim.margin(0.05), true).holds());
    assertFalse(new Finding(0.4, 0.4, 0.1, false).holds());
  }

  @Test
  void meanOfClaimsHasSmallerError() {
    Random random = new Random(1);
    Claim claim = Claim.of(scores(random, 0.5), scores(random, 0.5));
    Claim mean = Claim.mean(List.of(claim, claim, claim, claim));
    assertEquals(claim.difference(), mean.difference(), 1e-12);
    assertEquals(claim.error() / 2, mean.error(), 1e-12);
  }

  @Test
  void seedsDependOnSecretAndTask() {
    FreshSeeds seeds = new FreshSeeds("correct horse");
    assertEquals(seeds.draw("hall-v1", 10), new FreshSeeds("correct horse").draw("hall-v1", 10));
    assertNotEquals(seeds.draw("hall-v1", 10), seeds.draw("street-v1", 10));
    assertNotEquals(
        seeds.draw("hall-v1", 10), new FreshSeeds("battery staple").draw("hall-v1", 10));
    assertEquals(10, seeds.draw("hall-v1", 10).stream().distinct().count());
    assertTrue(seeds.draw("hall-v1", 10).stream().allMatch(seed -> seed > BenchmarkTask.TRAINING));
  }
}
