package org.hificamsim.core.policy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;

/** Tests the default methods of views and policies. */
class DefaultsTest {
  private static final int TARGETS = 70;
  private static final int LAST = 4;
  private static final int MOVING = 2;
  private static final int SEEN_BY_NOBODY = 40;
  private static final int SEEN_BY_OFFLINE = 41;
  private static final int SEEN_ONLY_BY_LAST = 42;
  private static final OracleView VIEW = view();

  @Test
  void masksEqualSingleDetections() {
    long[] masks = new long[7];
    Arrays.fill(masks, -1);
    VIEW.detections(4, masks, 3);
    long[] expected = new long[7];
    expected[6] = -1;
    for (int target = 0; target < TARGETS; target++) {
      for (int level = 0; level < 2; level++) {
        if (VIEW.present(target) && VIEW.detects(4, level, target)) {
          expected[3 * level + target / 64] |= 1L << target % 64;
        }
      }
    }
    assertArrayEquals(expected, masks);
    assertEquals(0b011011, expected[1]);
    assertEquals(0b111011, expected[4]);
  }

  @Test
  void marksTargetsDetectedByAnyOnlineCamera() {
    boolean[] coverable = new boolean[TARGETS];
    Arrays.fill(coverable, 0, 40, true);
    VIEW.markCoverable(coverable);
    for (int target = 0; target < TARGETS; target++) {
      boolean seen = VIEW.present(target) && target != SEEN_BY_NOBODY && target != SEEN_BY_OFFLINE;
      assertEquals(seen, coverable[target], "target " + target);
    }
  }

  @Test
  void findsPositionsOfSeenTargetsOnly() {
    SeenPairs pairs = new SeenPairs();
    VIEW.findSeen(pairs);
    int[] pairsOfLast =
        IntStream.range(0, pairs.count()).filter(pair -> pairs.camera(pair) == LAST).toArray();
    List<Integer> seen =
        IntStream.range(0, TARGETS).filter(target -> VIEW.sees(LAST, target)).boxed().toList();
    assertEquals(TARGETS - 4, seen.size(), "but for the two that are absent and the two not seen");
    assertEquals(seen, Arrays.stream(pairsOfLast).mapToObj(pairs::target).toList());
    for (int pair : pairsOfLast) {
      int target = pairs.target(pair);
      assertEquals(Math.hypot(3, target), VIEW.distance(LAST, target), 1e-12);
      assertEquals(Math.atan2(target, 3), VIEW.bearing(LAST, target), 1e-12);
      assertEquals(3, pairs.ahead(pair), 1e-12);
      assertEquals(pairs.target(pair), pairs.right(pair), 1e-12);
      assertEquals(Math.hypot(3, pairs.target(pair)), pairs.distance(pair), 1e-12);
    }
    assertEquals(Double.NaN, VIEW.distance(LAST, SEEN_BY_NOBODY));
    assertEquals(Double.NaN, VIEW.bearing(LAST, SEEN_BY_NOBODY));
    assertFalse(VIEW.sees(LAST, 66), "absent");
  }

  @Test
  void offlineAndMovingCamerasSeeNothing() {
    assertTrue(VIEW.sees(1, 1), "through its narrowest view");
    assertFalse(VIEW.sees(1, 3));
    for (int camera : new int[] {0, MOVING}) {
      assertFalse(VIEW.sees(camera, 1));
      assertEquals(0, VIEW.chances(camera, new int[TARGETS], new double[TARGETS]));
    }
    assertTrue(VIEW.moving(MOVING));
    assertFalse(VIEW.moving(1));
  }

  @Test
  void chanceIsOneOrZeroByDefault() {
    int[] targets = new int[TARGETS];
    double[] chances = new double[TARGETS];
    int count = VIEW.chances(1, targets, chances);
    int[] expected =
        IntStream.range(0, TARGETS)
            .filter(target -> VIEW.present(target) && VIEW.detects(1, 0, target))
            .toArray();
    assertArrayEquals(expected, Arrays.copyOf(targets, count));
    assertTrue(Arrays.stream(chances, 0, count).allMatch(chance -> chance == 1));
    assertEquals(0, VIEW.chance(1, 0, 3));
  }

  @Test
  void fixedCameraReachesAdjacentLevels() {
    assertEquals(2, VIEW.zooms(LAST));
    assertEquals(0, VIEW.pan(LAST, 1));
    assertEquals(7.5, VIEW.reach(LAST, 1), "the radius of the view");
    assertTrue(VIEW.reaches(LAST, 0) && VIEW.reaches(LAST, 1) && VIEW.reaches(LAST, 2));
    assertFalse(VIEW.reaches(LAST, 3) || VIEW.reaches(LAST, -1));
  }

  @Test
  void objectiveIsKMinAndSizeUnknownByDefault() {
    assertEquals(Objective.kMin(), VIEW.objective());
    assertEquals(Double.NaN, VIEW.targetSize(0));
    assertEquals(0.25, VIEW.seenConfidence(1, 1, 3), "the same as of any target");
  }

  @Test
  void aimingPolicyJumpsByDefault() {
    AimingZoomPolicy aiming =
        (AimingZoomPolicy)
            Proxy.newProxyInstance(
                ZoomPolicy.class.getClassLoader(),
                new Class<?>[] {AimingZoomPolicy.class},
                InvocationHandler::invokeDefault);
    assertTrue(aiming.jumps());
  }

  @Test
  void policySendsAndEstimatesNothingByDefault() {
    ZoomPolicy policy =
        new ZoomPolicy() {
          @Override
          public String name() {
            return "still";
          }

          @Override
          public void decide(NetworkView network, int[] levels) {}
        };
    double[] untouched = {7, 7};
    assertEquals("", policy.estimates(0, untouched, untouched));
    assertArrayEquals(new double[] {7, 7}, untouched);
    assertEquals(0, policy.messages());
    assertFalse(policy.jumps());
  }

  /**
   * Returns a view of five cameras with two levels; the first is offline. They stand at (1, 2) and
   * look to +x; target t is 3 m ahead of them and t m to the right. Targets 30 and 66 are absent.
   * Level 1 detects all but a few targets, level 0 some.
   */
  private static OracleView view() {
    InvocationHandler answers =
        (proxy, method, arguments) ->
            switch (method.getName()) {
              case "cameras" -> 5;
              case "views" -> 2;
              case "view" -> (int) arguments[0] == LAST ? 1 : 0;
              case "seeing" ->
                  (int) arguments[0] == MOVING ? -1 : ((OracleView) proxy).view((int) arguments[0]);
              case "zoom" -> new ZoomLevel(7.5, 2.5, 7.5, Double.NaN, Math.PI);
              case "online" -> (int) arguments[0] > 0;
              case "cameraX" -> 1.0;
              case "cameraY" -> 2.0;
              case "targetX" -> 4.0;
              case "cameraHeading" -> Math.PI / 2;
              case "targetY" -> 2.0 - (int) arguments[0];
              case "confidence" -> 0.25;
              case "targets" -> TARGETS;
              case "present" -> (int) arguments[0] != 66 && (int) arguments[0] != 30;
              case "detects" -> detects((int) arguments[0], (int) arguments[1], (int) arguments[2]);
              default -> InvocationHandler.invokeDefault(proxy, method, arguments);
            };
    return (OracleView)
        Proxy.newProxyInstance(
            OracleView.class.getClassLoader(), new Class<?>[] {OracleView.class}, answers);
  }

  /**
   * Whether a view detects a target; cameras and views beyond the last would detect targets that
   * nobody sees.
   */
  private static boolean detects(int camera, int view, int target) {
    return switch (target) {
      case SEEN_BY_NOBODY -> camera > LAST || view > 1;
      case SEEN_BY_OFFLINE -> camera == 0;
      case SEEN_ONLY_BY_LAST -> camera == LAST && view == 1;
      default -> view == 1 || target % 3 != 0;
    };
  }
}
