package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import org.hificamsim.core.metrics.DetectionChances;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.junit.jupiter.api.Test;

class RunCoverageTest {
  private final RunCoverage coverage = new RunCoverage();

  @Test
  void aggregatesExpectedValuesOverSteps() {
    StepCoverage half = new StepCoverage();
    half.expect(new Coins());
    coverage.stepped(networkWithViews(0, 0), half);
    coverage.stepped(networkWithViews(0, 0), half);
    assertEquals(2 * 0.75 * 0.5, coverage.expectedPerformance());
    assertEquals(0.75, coverage.expectedMeanK());
    assertEquals(0.5, coverage.leastExpectedK());
    assertEquals(0.5, coverage.leastChance());
  }

  @Test
  void expectedValuesAreNaNWithoutChance() {
    step(0);
    assertEquals(Double.NaN, coverage.expectedPerformance());
    assertEquals(Double.NaN, coverage.leastChance());
  }

  /** Both cameras detect target 0, and the first also target 1, each with a chance of 0.5. */
  private static final class Coins implements DetectionChances {
    @Override
    public int cameras() {
      return 2;
    }

    @Override
    public int targets() {
      return 2;
    }

    @Override
    public boolean present(int target) {
      return true;
    }

    @Override
    public int chances(int camera, int[] targets, double[] chances) {
      int count = camera == 0 ? 2 : 1;
      for (int i = 0; i < count; i++) {
        targets[i] = i;
        chances[i] = 0.5;
      }
      return count;
    }
  }

  private void step(int... views) {
    coverage.stepped(networkWithViews(views), new StepCoverage());
  }

  /** A network that only answers the number of cameras and their views. */
  private static OracleView networkWithViews(int... views) {
    return (OracleView)
        Proxy.newProxyInstance(
            OracleView.class.getClassLoader(),
            new Class<?>[] {OracleView.class},
            (proxy, method, arguments) ->
                switch (method.getName()) {
                  case "cameras" -> views.length;
                  case "view" -> views[(int) arguments[0]];
                  case "online", "moving" -> false;
                  default -> 0.0;
                });
  }

  @Test
  void listenerIsNamedAfterItsClass() {
    assertEquals("RunCoverage", coverage.name());
  }
}
