package org.hificamsim.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

class CoveragePoliciesTest {
  private static final Set<String> GLOBAL =
      Set.of("optimal", "bound", "optimal-expected", "one-hop", "best-fixed", "independent-greedy");

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @TestFactory
  Stream<DynamicNode> everyRegisteredPolicyKeepsTheContract() {
    return registry.names().stream()
        .map(
            name ->
                DynamicContainer.dynamicContainer(
                    name,
                    new ZoomPolicyContract(() -> registry.create(name), GLOBAL.contains(name))
                        .tests()));
  }

  /** Beyond the defaults: what learners may take as their state. */
  @TestFactory
  Stream<DynamicNode> learnersOfPicturesKeepTheContract() {
    return Stream.of("sarsa", "q-learning", "qb-sarsa")
        .flatMap(name -> Stream.of(name + ":state=picture", name + ":state=view-picture-depth"))
        .map(
            spec ->
                DynamicContainer.dynamicContainer(
                    spec, new ZoomPolicyContract(() -> registry.create(spec), false).tests()));
  }

  @TestFactory
  Stream<? extends DynamicNode> aPolicyOfTwoMethodsKeepsTheContract() {
    return new ZoomPolicyContract(MiddlePolicy::new, false).tests();
  }

  @Test
  void everyPolicyIsRegisteredUnderItsOwnNameWithASummary() {
    for (Registry.Entry<ZoomPolicy> entry : registry.entries()) {
      assertEquals(entry.name(), registry.create(entry.name()).name());
      assertFalse(entry.summary().isBlank());
    }
  }

  @Test
  void thePolicyThatWasCalledGreedyIsUnderstoodByThatNameAndNotListed() {
    assertEquals("independent-greedy", registry.create("greedy:among=all").name());
    assertFalse(registry.names().contains("greedy"));
  }

  @Test
  void everyOptionIsListedWithItsMeaning() {
    for (String name : registry.names()) {
      registry.options(name).forEach(option -> assertFalse(option.meaning().isBlank(), name));
    }
    assertTrue(
        registry.options("epsilon-greedy").stream()
            .anyMatch(option -> option.key().equals("epsilon")));
  }

  @Test
  void anUnknownOptionIsRefusedWithTheValidOnes() {
    for (String name : registry.names()) {
      InputException refused =
          assertThrows(InputException.class, () -> registry.create(name + ":nonsense=1"));
      assertTrue(refused.getMessage().contains("nonsense"), refused.getMessage());
    }
  }

  /** The least that a user can write. */
  private static final class MiddlePolicy implements ZoomPolicy {
    @Override
    public String name() {
      return "middle";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < network.cameras(); camera++) {
        views[camera] = network.views(camera) / 2;
      }
    }
  }
}
