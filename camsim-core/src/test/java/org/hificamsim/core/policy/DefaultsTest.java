package org.hificamsim.core.policy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What views and policies do that leave out what they may. */
class DefaultsTest {
  private static final int TARGETS = 70;
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
      assertEquals(VIEW.present(target), coverable[target], "target " + target);
    }
  }

  @Test
  void workIsDoneInOnePart() {
    List<String> parts = new ArrayList<>();
    VIEW.divide(
        parts,
        (network, work, from, to) -> {
          assertSame(VIEW, network);
          work.add(from + " to " + to);
        });
    assertEquals(List.of("0 to 5"), parts);
  }

  @Test
  void aNetworkWithAnOraclesKnowledgeIsItsOwnOracle() {
    assertSame(VIEW, VIEW.oracle());
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
    assertEquals("", policy.estimates(VIEW, 0, untouched, untouched));
    assertArrayEquals(new double[] {7, 7}, untouched);
    assertEquals(0, policy.messages());
  }

  /**
   * Five cameras of two levels; targets 30 and 66 are absent, level 1 detects all, level 0 some.
   */
  private static OracleView view() {
    InvocationHandler answers =
        (proxy, method, arguments) ->
            switch (method.getName()) {
              case "cameras" -> 5;
              case "views" -> 2;
              case "online" -> (int) arguments[0] > 0;
              case "targets" -> TARGETS;
              case "present" -> (int) arguments[0] != 66 && (int) arguments[0] != 30;
              case "detects" -> (int) arguments[1] == 1 || (int) arguments[2] % 3 != 0;
              default -> InvocationHandler.invokeDefault(proxy, method, arguments);
            };
    return (OracleView)
        Proxy.newProxyInstance(
            OracleView.class.getClassLoader(), new Class<?>[] {OracleView.class}, answers);
  }
}
