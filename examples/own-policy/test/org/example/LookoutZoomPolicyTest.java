package org.example;

import java.util.stream.Stream;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Tests that the policy does what the engine expects of every policy. */
class LookoutZoomPolicyTest {
  @TestFactory
  Stream<DynamicTest> policyKeepsItsContract() {
    return new ZoomPolicyContract(LookoutZoomPolicyTest::lookout, false).tests();
  }

  private static ZoomPolicy lookout() {
    ZoomPolicy policy = new LookoutZoomPolicy();
    policy.configure(Options.none("lookout"));
    return policy;
  }
}
