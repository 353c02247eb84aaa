package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class DomainsTest {
  @Test
  void aTightTargetForcesTheCamerasThatCanCoverIt() {
    Domains domains = domains(3, new long[][] {{0b001, 0b010}, {0b110, 0b001}, {0b100, 0b011}});
    assertTrue(domains.require(1));
    assertTrue(domains.choose(0));
    assertTrue(domains.remove(4));
    assertFalse(domains.remaining().has(3), "only camera 1 can cover target 1 now");
  }

  @Test
  void aSupplyBelowWhatIsRequiredIsImpossible() {
    assertFalse(domains(2, new long[][] {{0b01, 0b10}, {0b01}}).require(2));
  }

  @Test
  void tooLittleWeightInAllIsImpossible() {
    assertFalse(domains(2, new long[][] {{0b01, 0b10}}).require(1));
  }

  @Test
  void undoRestoresEverythingExactly() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 2_000; trial++) {
      long[][] sets = Problems.random(random, 6, 4, 7, 0.5);
      Domains domains = domains(7, sets);
      Domains untouched = domains(7, sets);
      domains.require(2);
      untouched.require(2);
      int mark = domains.mark();
      for (int change = 0; change < 8; change++) {
        int camera = random.nextInt(6);
        if (domains.remaining().count(camera) == 0) {
          break;
        }
        int set = domains.remaining().first(camera);
        if (!change(domains, random.nextInt(3), set)) {
          break;
        }
      }
      domains.undo(mark);
      assertSame(untouched, domains, sets);
    }
  }

  private static boolean change(Domains domains, int kind, int set) {
    return switch (kind) {
      case 0 -> domains.choose(set);
      case 1 -> domains.remove(set);
      default -> domains.removeWithLesser(set);
    };
  }

  private static void assertSame(Domains expected, Domains actual, long[][] sets) {
    assertEquals(expected.mark(), actual.mark());
    assertEquals(expected.bound(), actual.bound());
    assertEquals(expected.weights().surplus(2), actual.weights().surplus(2));
    for (int target = 0; target < 7; target++) {
      assertEquals(expected.supply().slack(target), actual.supply().slack(target));
      assertEquals(expected.supply().lack(target), actual.supply().lack(target));
    }
    int all = 0;
    for (int camera = 0; camera < sets.length; camera++) {
      assertEquals(expected.supply().undecided(camera, 0), actual.supply().undecided(camera, 0));
      assertEquals(expected.remaining().count(camera), actual.remaining().count(camera));
      all += sets[camera].length;
    }
    for (int set = 0; set < all; set++) {
      assertEquals(expected.remaining().has(set), actual.remaining().has(set));
      assertEquals(expected.weights().loss(set), actual.weights().loss(set));
    }
  }

  private static Domains domains(int targets, long[][] sets) {
    Domains domains = new Domains(Problems.problem(targets, sets));
    domains.reset();
    return domains;
  }
}
