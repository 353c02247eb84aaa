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
  private static final Set<String> ORACLES =
      Set.of(
          "optimal",
          "bound",
          "optimal-expected",
          "one-hop",
          "best-fixed",
          "reachable",
          "independent-greedy");

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @TestFactory
  Stream<DynamicNode> everyPolicyKeepsTheContract() {
    return registry.names().stream()
        .map(
            name ->
                DynamicContainer.dynamicContainer(
                    name,
                    new ZoomPolicyContract(() -> registry.create(name), ORACLES.contains(name))
                        .tests()));
  }

  /** Learners with states other than the default. */
  @TestFactory
  Stream<DynamicNode> pictureLearnersKeepTheContract() {
    return Stream.of("sarsa", "q-learning", "qb-sarsa")
        .flatMap(name -> Stream.of(name + ":state=picture", name + ":state=view-picture-depth"))
        .map(
            spec ->
                DynamicContainer.dynamicContainer(
                    spec, new ZoomPolicyContract(() -> registry.create(spec), false).tests()));
  }

  @TestFactory
  Stream<? extends DynamicNode> smallestPossiblePolicyKeepsTheContract() {
    return new ZoomPolicyContract(MiddlePolicy::new, false).tests();
  }

  @Test
  void everyPolicyHasItsNameAndASummary() {
    for (Registry.Entry<ZoomPolicy> entry : registry.entries()) {
      assertEquals(entry.name(), registry.create(entry.name()).name());
      assertFalse(entry.summary().isBlank());
    }
  }

  @Test
  void oldNameGreedyIsAcceptedButNotListed() {
    assertEquals("independent-greedy", registry.create("greedy:among=all").name());
    assertFalse(registry.names().contains("greedy"));
  }

  @Test
  void everyOptionHasAMeaning() {
    for (String name : registry.names()) {
      registry.options(name).forEach(option -> assertFalse(option.meaning().isBlank(), name));
    }
    assertTrue(
        registry.options("epsilon-greedy").stream()
            .anyMatch(option -> option.key().equals("epsilon")));
  }

  @Test
  void rejectsUnknownOptions() {
    for (String name : registry.names()) {
      InputException error =
          assertThrows(InputException.class, () -> registry.create(name + ":nonsense=1"));
      assertTrue(error.getMessage().contains("nonsense"), error.getMessage());
    }
  }

  /** The smallest policy that a user can write. */
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
