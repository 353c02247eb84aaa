package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class AssociationTest {
  private static final Grid GRID = new Grid(0, 0, 1, 40, 40);
  private static final Parameters PARAMETERS =
      Parameters.from(Options.parse("cooperative", "identity=none"));

  private final ToyNetwork network = new ToyNetwork(2, 1);
  private final TargetTracks tracks = new TargetTracks(PARAMETERS, Obstacles.NONE, 0);
  private final Association association = new Association(GRID, tracks);

  /** What a camera at the origin sees, some metres ahead (y) and to the right (x). */
  private int[] see(long step, double... places) {
    SeenPairs pairs = new SeenPairs();
    SightingReport unnamed = new SightingReport(false);
    while (network.step() < step) {
      network.nextStep();
    }
    unnamed.begin(network, 0);
    for (int i = 0; i < places.length / 2; i++) {
      pairs.add(0, i % 2, places[2 * i + 1], places[2 * i]);
      unnamed.add(network, pairs, i);
    }
    SightingReport report = association.name(unnamed, step);
    int[] numbers = new int[report.count()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = report.target(i);
      tracks.see(numbers[i], step, step, report.x(i), report.y(i), 1);
    }
    return numbers;
  }

  @Test
  void twoThatMeetGoOnAsTheyWent() {
    int[] first = see(0, 10, 10, 10, 20);
    assertNotEquals(first[0], first[1]);
    for (int step = 1; step <= 10; step++) {
      tracks.step();
      int[] numbers = see(step, 10.1, 20 - step, 10, 10 + step); // in the other order
      assertEquals(first[1], numbers[0], "step " + step);
      assertEquals(first[0], numbers[1], "step " + step);
    }
    assertEquals(2, tracks.count());
  }

  /** The nearest to each would be the same track for both. */
  @Test
  void theSumOfDistancesDecides() {
    int[] first = see(0, 10, 10, 12, 10);
    tracks.step();
    int[] numbers = see(1, 11.5, 10, 13, 10);
    assertEquals(first[0], numbers[0]);
    assertEquals(first[1], numbers[1]);
  }

  @Test
  void twoCamerasThatSeeOneTargetMakeOneTrack() {
    int first = see(0, 10, 10)[0];
    assertEquals(first, see(0, 10, 10)[0]);
    assertNotEquals(first, see(0, 11, 10)[0]);
    assertEquals(2, tracks.count());
  }

  @Test
  void whatIsTooFarFromAllTracksIsNew() {
    int first = see(0, 10, 10)[0];
    tracks.step();
    assertNotEquals(first, see(1, 20, 10)[0]);
  }
}
