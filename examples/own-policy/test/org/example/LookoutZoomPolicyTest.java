package org.example;

import java.util.stream.Stream;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** The policy owes the engine what every policy does. */
class LookoutZoomPolicyTest {
  @TestFactory
  Stream<DynamicTest> keepsTheContract() {
    return new ZoomPolicyContract(LookoutZoomPolicyTest::lookout, false).tests();
  }

  private static ZoomPolicy lookout() {
    ZoomPolicy policy = new LookoutZoomPolicy();
    policy.configure(Options.none("lookout"));
    return policy;
  }
}
