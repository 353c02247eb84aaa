package org.example;

import java.util.stream.Stream;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** The policy owes the engine what every policy does. */
class PatrolZoomPolicyTest {
  @TestFactory
  Stream<DynamicTest> keepsTheContract() {
    return new ZoomPolicyContract(PatrolZoomPolicyTest::patrol, false).tests();
  }

  private static ZoomPolicy patrol() {
    ZoomPolicy policy = new PatrolZoomPolicy();
    policy.configure(Options.none("patrol"));
    return policy;
  }
}
