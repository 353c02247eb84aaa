package org.hificamsim.worlds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;
import org.junit.jupiter.api.Test;

/** Tests actions by cameras of mate-4v8-9, which take time to turn, and of cluster-random. */
class ActionsTest {
  private static Played played(String scenario, ActionKind kind) {
    return new Played(Played.settings(scenario, "coverage", kind, 100_000, true), 1, 1, 4);
  }

  @Test
  void instantCameraMayChooseAnyView() {
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
  void movingCameraMayOnlyContinue() {
    try (Played played = played("mate-4v8-9", ActionKind.VIEW)) {
      int stepsOnTheWay = 0;
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
          stepsOnTheWay++;
        }
      }
      assertTrue(stepsOnTheWay > 50, stepsOnTheWay + " of 500 steps on the way");
    }
  }

  @Test
  void stepActionsMoveToNextPanAndZoom() {
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

  /** At full speed, a step pans by 5 degrees and zooms by 2.5; levels are 30 degrees apart. */
  @Test
  void ratesTurnAndZoomAtDriveSpeed() {
    try (Played played = played("mate-4v8-9", ActionKind.RATES)) {
      NetworkView network = played.worlds().network(0);
      assertEquals(0, degrees(network), 1e-9);
      assertEquals(5, network.zoomOf(0, network.view(0)), "the widest of six levels");
      rates(played, 20, 500, 0);
      assertEquals(50, degrees(network), 1e-9, "at half the speed, to the right");
      rates(played, 4, -1000, 0);
      assertEquals(30, degrees(network), 1e-9, "at full speed, to the left");
      rates(played, 24, 0, -1000);
      assertEquals(3, network.zoomOf(0, network.view(0)), "two levels narrower");
      rates(played, 200, 1000, -1000);
      assertEquals(175, degrees(network), 1e-9, "no farther than its last pan angle");
      assertEquals(0, network.zoomOf(0, network.view(0)), "no narrower than its first level");
      rates(played, 1, -1000, 1000);
      assertEquals(170, degrees(network), 1e-9, "and back at once");
    }
  }

  @Test
  void ratesSteerMovingCameraAndNeedNoMask() {
    try (Played played = played("mate-4v8-9", ActionKind.RATES)) {
      int stepsOnTheWay = 0;
      for (int step = 0; step < 30; step++) {
        NetworkView network = played.worlds().network(0);
        int goal = network.view(0);
        boolean moving = network.moving(0);
        rates(played, 1, 1000, -1000);
        stepsOnTheWay += moving && network.view(0) != goal ? 1 : 0;
      }
      assertTrue(stepsOnTheWay > 5, stepsOnTheWay + " changed on their way");
      assertEquals(2 * played.worlds().network(0).cameras(), played.bytes("masks", 0).length);
    }
  }

  /** A camera that needs no time turns by a pan angle, and zooms by a level. */
  @Test
  void ratesSteerInstantCamera() {
    try (Played played = played("cluster-random", ActionKind.RATES)) {
      NetworkView network = played.worlds().network(0);
      rates(played, 1, 0, -1000);
      assertEquals(3, network.view(0));
      rates(played, 2, 0, -250);
      assertEquals(3, network.view(0), "half a level is not yet the next one");
      rates(played, 1, 0, -250);
      assertEquals(2, network.view(0));
    }
  }

  private static void rates(Played played, int steps, int turn, int wider) {
    for (int step = 0; step < steps; step++) {
      played.stepAll(1000 + turn, 1000 + wider);
    }
  }

  private static double degrees(NetworkView network) {
    return Math.toDegrees(network.pan(0, network.view(0)));
  }

  @Test
  void offlineCameraMayGetAnyOfItsViews() {
    try (Played played = played("car-park", ActionKind.VIEW)) {
      for (int step = 0; step < 205; step++) {
        played.step(4);
      }
      NetworkView network = played.worlds().network(0);
      assertFalse(network.online(3), "shop-east fails in step 200");
      byte[] masks = played.bytes("masks", 0);
      int width = masks.length / network.cameras();
      byte[] cameraMask = Arrays.copyOfRange(masks, 3 * width, 4 * width);
      assertEquals(
          network.views(3), IntStream.range(0, width).filter(i -> cameraMask[i] == 1).count());
    }
  }

  private static byte[] mask(Played played, int camera) {
    byte[] mask = new byte[6];
    System.arraycopy(played.bytes("masks", 0), 6 * camera, mask, 0, 6);
    return mask;
  }
}
