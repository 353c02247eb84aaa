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

  /**
   * Lets a camera at the origin see targets, and returns the numbers of their tracks.
   *
   * @param positions x and y of each target in turn, metres to the right of the camera and ahead
   */
  private int[] see(long step, double... positions) {
    SeenPairs pairs = new SeenPairs();
    SightingReport unidentified = new SightingReport(false);
    while (network.step() < step) {
      network.nextStep();
    }
    unidentified.begin(network, 0);
    for (int i = 0; i < positions.length / 2; i++) {
      pairs.add(0, i % 2, positions[2 * i + 1], positions[2 * i]);
      unidentified.add(network, pairs, i);
    }
    SightingReport report = association.identifyTargets(unidentified, step);
    int[] numbers = new int[report.count()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = report.target(i);
      tracks.see(report, i, step);
    }
    return numbers;
  }

  @Test
  void keepsTracksOfTargetsThatPassEachOther() {
    int[] first = see(0, 10, 10, 10, 20);
    assertNotEquals(first[0], first[1]);
    for (int step = 1; step <= 10; step++) {
      tracks.step();
      int[] numbers = see(step, 10.1, 20 - step, 10, 10 + step); // second target first
      assertEquals(first[1], numbers[0], "step " + step);
      assertEquals(first[0], numbers[1], "step " + step);
    }
    assertEquals(2, tracks.count());
  }

  /** The nearest track is the same one for both sightings. */
  @Test
  void minimisesTheSumOfDistances() {
    int[] first = see(0, 10, 10, 12, 10);
    tracks.step();
    int[] numbers = see(1, 11.5, 10, 13, 10);
    assertEquals(first[0], numbers[0]);
    assertEquals(first[1], numbers[1]);
  }

  @Test
  void makesOneTrackOfATargetThatTwoCamerasSee() {
    int first = see(0, 10, 10)[0];
    assertEquals(first, see(0, 10, 10)[0]);
    assertNotEquals(first, see(0, 11, 10)[0]);
    assertEquals(2, tracks.count());
  }

  @Test
  void startsANewTrackFarFromAllOthers() {
    int first = see(0, 10, 10)[0];
    tracks.step();
    assertNotEquals(first, see(1, 20, 10)[0]);
  }
}
