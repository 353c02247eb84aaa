package org.hificamsim.worlds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.policy.NetworkView;
import org.junit.jupiter.api.Test;

/** Cameras of mate-4v8-9 take their time to turn; those of cluster-random need none. */
class ActionsTest {
  private static Played played(String scenario, ActionKind kind) {
    return new Played(Played.settings(scenario, "coverage", kind, 100_000, true), 1, 1, 4);
  }

  @Test
  void aCameraThatNeedsNoTimeMayGoAnywhere() {
    try (Played played = played("cluster-random", ActionKind.VIEW)) {
      for (int step = 0; step < 50; step++) {
        for (byte mask : played.bytes("masks", 0)) {
          assertEquals(1, mask);
        }
        played.step(4);
      }
    }
  }

  @Test
  void aCameraOnItsWayMayOnlyGoOnAndDoes() {
    try (Played played = played("mate-4v8-9", ActionKind.VIEW)) {
      int onTheWay = 0;
      for (int step = 0; step < 500; step++) {
        NetworkView network = played.worlds().network(0);
        boolean moving = network.moving(1);
        int goal = network.view(1);
        byte[] masks = played.bytes("masks", 0);
        int width = masks.length / network.cameras();
        int allowed = 0;
        for (int view = 0; view < width; view++) {
          allowed += masks[width + view];
        }
        assertEquals(moving ? 1 : network.views(1), allowed);
        assertEquals(1, masks[width + goal]);
        played.step(4);
        if (moving) {
          assertEquals(goal, played.worlds().network(0).view(1));
          onTheWay++;
        }
      }
      assertTrue(onTheWay > 50, onTheWay + " of 500 steps on the way");
    }
  }

  @Test
  void stepsGoToTheNextPanAndZoom() {
    try (Played played = played("cluster-random", ActionKind.STEPS)) {
      assertEquals(4, played.worlds().network(0).view(3), "the widest of five levels, at first");
      assertArrayEquals(new byte[] {0, 1, 0, 1, 1, 0}, mask(played, 3));
      played.stepAll(1, 0);
      assertEquals(3, played.worlds().network(0).view(3));
      assertArrayEquals(new byte[] {0, 1, 0, 1, 1, 1}, mask(played, 3));
      played.stepAll(0, 2);
      assertEquals(4, played.worlds().network(0).view(3), "no pan to the left, but wider");
      played.stepAll(2, 2);
      assertEquals(4, played.worlds().network(0).view(3), "nothing is wider");
    }
  }

  private static byte[] mask(Played played, int camera) {
    byte[] mask = new byte[6];
    System.arraycopy(played.bytes("masks", 0), 6 * camera, mask, 0, 6);
    return mask;
  }
}
