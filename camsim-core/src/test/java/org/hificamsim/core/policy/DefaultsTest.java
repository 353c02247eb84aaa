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

/** What views and policies do that leave out what they may. */
class DefaultsTest {
  private static final int TARGETS = 70;
  private static final int LAST = 4;
  private static final int ON_ITS_WAY = 2;
  private static final int NOBODYS = 40;
  private static final int OFFLINES = 41;
  private static final int LAST_ONES = 42;
  private static final OracleView VIEW = view();

  @Test
  void detectionsAreTheAnswersToSingleQuestions() {
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
  void whatSomeViewOfSomeCameraOnlineDetectsCanBeCovered() {
    boolean[] coverable = new boolean[TARGETS];
    Arrays.fill(coverable, 0, 40, true);
    VIEW.markCoverable(coverable);
    for (int target = 0; target < TARGETS; target++) {
      boolean seen = VIEW.present(target) && target != NOBODYS && target != OFFLINES;
      assertEquals(seen, coverable[target], "target " + target);
    }
  }

  @Test
  void whereTargetsAreIsToldOfThoseThatACameraSeesAlone() {
    SeenPairs pairs = new SeenPairs();
    VIEW.findSeen(pairs);
    int[] ofLast =
        IntStream.range(0, pairs.count()).filter(pair -> pairs.camera(pair) == LAST).toArray();
    List<Integer> seen =
        IntStream.range(0, TARGETS).filter(target -> VIEW.sees(LAST, target)).boxed().toList();
    assertEquals(TARGETS - 4, seen.size(), "but for the two that are absent and the two not seen");
    assertEquals(seen, Arrays.stream(ofLast).mapToObj(pairs::target).toList());
    for (int pair : ofLast) {
      int target = pairs.target(pair);
      assertEquals(Math.hypot(3, target), VIEW.distance(LAST, target), 1e-12);
      assertEquals(Math.atan2(target, 3), VIEW.bearing(LAST, target), 1e-12);
      assertEquals(3, pairs.ahead(pair), 1e-12);
      assertEquals(pairs.target(pair), pairs.right(pair), 1e-12);
      assertEquals(Math.hypot(3, pairs.target(pair)), pairs.distance(pair), 1e-12);
    }
    assertEquals(Double.NaN, VIEW.distance(LAST, NOBODYS));
    assertEquals(Double.NaN, VIEW.bearing(LAST, NOBODYS));
    assertFalse(VIEW.sees(LAST, 66), "absent");
  }

  @Test
  void aCameraThatIsOfflineOrOnItsWaySeesNothing() {
    assertTrue(VIEW.sees(1, 1), "through its narrowest view");
    assertFalse(VIEW.sees(1, 3));
    for (int camera : new int[] {0, ON_ITS_WAY}) {
      assertFalse(VIEW.sees(camera, 1));
      assertEquals(0, VIEW.chances(camera, new int[TARGETS], new double[TARGETS]));
    }
    assertTrue(VIEW.moving(ON_ITS_WAY));
    assertFalse(VIEW.moving(1));
  }

  @Test
  void withoutLuckAChanceIsOneOrZero() {
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
  void aCameraThatCannotTurnHasItsLevelsAloneAndReachesThoseBesideItsOwn() {
    assertEquals(2, VIEW.zooms(LAST));
    assertEquals(0, VIEW.pan(LAST, 1));
    assertEquals(7.5, VIEW.reach(LAST, 1), "the radius of the view");
    assertTrue(VIEW.reaches(LAST, 0) && VIEW.reaches(LAST, 1) && VIEW.reaches(LAST, 2));
    assertFalse(VIEW.reaches(LAST, 3) || VIEW.reaches(LAST, -1));
  }

  @Test
  void whatIsNotSaidIsKMinAndAnUnknownSize() {
    assertEquals(Objective.kMin(), VIEW.objective());
    assertEquals(Double.NaN, VIEW.targetSize(0));
    assertEquals(0.25, VIEW.seenConfidence(1, 1, 3), "the same as of any target");
  }

  @Test
  void onlyAPolicyThatAimsTakesNoTimeForAMove() {
    AimingZoomPolicy aiming =
        (AimingZoomPolicy)
            Proxy.newProxyInstance(
                ZoomPolicy.class.getClassLoader(),
                new Class<?>[] {AimingZoomPolicy.class},
                InvocationHandler::invokeDefault);
    assertTrue(aiming.jumps());
  }

  @Test
  void aPolicySendsNothingAndEstimatesNothing() {
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
   * Five cameras of two levels, of which the first is offline. They stand at (1, 2) and look to +x;
   * target t is 3 m ahead of them and t m to the right. Targets 30 and 66 are absent, level 1
   * detects all but a few, level 0 some.
   */
  private static OracleView view() {
    InvocationHandler answers =
        (proxy, method, arguments) ->
            switch (method.getName()) {
              case "cameras" -> 5;
              case "views" -> 2;
              case "view" -> (int) arguments[0] == LAST ? 1 : 0;
              case "seeing" ->
                  (int) arguments[0] == ON_ITS_WAY
                      ? -1
                      : ((OracleView) proxy).view((int) arguments[0]);
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

  /** Cameras, views and targets that there are not would detect everything. */
  private static boolean detects(int camera, int view, int target) {
    return switch (target) {
      case NOBODYS -> camera > LAST || view > 1;
      case OFFLINES -> camera == 0;
      case LAST_ONES -> camera == LAST && view == 1;
      default -> view == 1 || target % 3 != 0;
    };
  }
}
