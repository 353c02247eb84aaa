package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class IdentitySwitchesTest {
  private static final Parameters PARAMETERS =
      Parameters.from(Options.parse("cooperative", "identity=none,memory=2"));

  private final ToyNetwork network = new ToyNetwork(3, 1);
  private final TargetTracks tracks = new TargetTracks(PARAMETERS, Obstacles.NONE, 8);
  private final IdentitySwitches switches = new IdentitySwitches(tracks, 3);

  /**
   * Assigns the sightings of targets to tracks; returns the switches so far.
   *
   * @param numbers the target and its track in turn
   */
  private long see(long step, int... numbers) {
    while (network.step() < step) {
      network.nextStep();
    }
    SeenPairs pairs = new SeenPairs();
    SightingReport report = new SightingReport(false);
    report.begin(network, 0);
    int[] assigned = new int[numbers.length / 2];
    for (int i = 0; i < assigned.length; i++) {
      pairs.add(0, numbers[2 * i], 3, i);
      report.add(network, pairs, i);
      assigned[i] = numbers[2 * i + 1];
    }
    SightingReport identified = report.copy(assigned);
    for (int i = 0; i < assigned.length; i++) {
      tracks.see(identified, i, step);
    }
    switches.count(identified);
    return switches.count();
  }

  @Test
  void targetsThatSwapTracksSwitchTwice() {
    assertEquals(0, see(0, 0, 5, 1, 6));
    assertEquals(0, see(1, 0, 5, 1, 6, 2, 7));
    assertEquals(2, see(2, 1, 5, 0, 6, 2, 7));
    assertEquals(2, see(3, 1, 5, 0, 6));
  }

  @Test
  void targetOnTrackOfAnotherSwitchesOnce() {
    see(0, 0, 5);
    assertEquals(0, see(1, 1, 5));
    assertEquals(1, see(2, 1, 6));
    assertEquals(1, see(3, 0, 5));
  }

  @Test
  void targetSeenAfterItsTrackWasForgottenSwitches() {
    see(0, 0, 5);
    tracks.forget(9, new SearchMap(PARAMETERS, new Grid(0, 0, 1, 9, 9), new boolean[81], 1));
    assertEquals(1, see(9, 0, 5));
  }
}
