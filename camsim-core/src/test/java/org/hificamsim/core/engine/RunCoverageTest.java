package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.junit.jupiter.api.Test;

class RunCoverageTest {
  private final RunCoverage coverage = new RunCoverage();

  @Test
  void countsTheZoomChangesOfCamerasThatCameLater() {
    step(2);
    step(2, 0);
    assertEquals(0, coverage.zoomChanges());
    step(1, 0, 1);
    assertEquals(1, coverage.zoomChanges());
    step(1, 2, 0);
    assertEquals(3, coverage.zoomChanges());
  }

  private void step(int... views) {
    coverage.stepped(at(views), new StepCoverage());
  }

  /** Cameras at these views, of which nothing else is asked. */
  private static NetworkView at(int... views) {
    return (NetworkView)
        Proxy.newProxyInstance(
            NetworkView.class.getClassLoader(),
            new Class<?>[] {NetworkView.class},
            (proxy, method, arguments) ->
                method.getName().equals("cameras") ? views.length : views[(int) arguments[0]]);
  }
}
