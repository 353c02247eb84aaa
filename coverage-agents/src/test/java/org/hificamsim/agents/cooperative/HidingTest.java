package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hificamsim.agents.toy.ToyNetwork;
import org.junit.jupiter.api.Test;

/** Tests how targets hide each other from a camera at the origin. */
class HidingTest {
  private final ToyNetwork network = new ToyNetwork(0, 1);
  private final Hiding hiding = new Hiding();

  private void place(double width, double nearerX, double nearerY, double weight) {
    hiding.clear(width, 0);
    hiding.add(network.cameraX(0) + 10, network.cameraY(0), 1);
    hiding.add(network.cameraX(0) + nearerX, network.cameraY(0) + nearerY, weight);
  }

  private double visible(int target) {
    return hiding.visibleShare(network, 0, target, 1);
  }

  @Test
  void nearerTargetHidesTheOneBehind() {
    place(0.5, 5, 0, 1);
    assertEquals(0, visible(0));
    assertEquals(1, visible(1));
  }

  @Test
  void targetOffTheLineOfSightHidesNothing() {
    place(0.5, 5, 1, 1);
    assertEquals(1, visible(0));
  }

  @Test
  void uncertainTargetHidesInProportionToItsWeight() {
    place(0.5, 5, 0, 0.3);
    assertEquals(0.7, visible(0), 1e-12);
  }

  @Test
  void edgeOfDiscIsBlurred() {
    place(0.5, 5, 0.25, 1);
    assertEquals(0.5, visible(0), 1e-12);
  }

  @Test
  void hidesNothingWithoutOcclusion() {
    place(0, 5, 0, 1);
    assertEquals(1, visible(0));
  }
}
