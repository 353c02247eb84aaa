package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

class PictureLearnersTest {
  /** A target walks from the camera's left to its right and back, and the camera has to follow. */
  private static final String SHUTTLE =
      "<optics name='o' hfov='20' reach='15' pan='-60:60:10'/>"
          + "<camera name='a' x='0' y='0' heading='0' viewing_angle='20' range='15' optics='o'/>"
          + "<object_with_waypoints features='1' speed='0.5'>"
          + "<waypoint x='-10' y='6'/><waypoint x='10' y='6'/></object_with_waypoints>";

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @Test
  void countsStatesOfPictures() {
    assertEquals(7, values("picture").state(0, 4, 7));
    assertEquals(63, values("picture-depth").state(0, 4, 63));
    assertEquals(7 * 6 + 4, values("view-picture").state(0, 4, 7));
    assertEquals(63 * 6 + 4, values("view-picture-depth").state(0, 4, 63));
  }

  @Test
  void pictureStatesBeatCounts() {
    int picture = detected("sarsa:state=view-picture,gamma=0.9");
    int count = detected("sarsa:state=level-count,gamma=0.9");
    assertTrue(picture > 1.2 * count, picture + " compared with " + count);
  }

  @Test
  void rejectsTablesThatAreTooLarge() {
    ToyNetwork turning = new ToyNetwork(1, 3_000);
    ZoomPolicy policy = registry.create("sarsa:state=view-picture-depth");
    InputException error = assertThrows(InputException.class, () -> turning.begin(policy, 1));
    assertEquals(
        "a camera's table of action values needs more than 268435456 entries for 1 targets and"
            + " 3000 views. Maybe give the option state=none",
        error.getMessage());
  }

  private int detected(String spec) {
    Simulation run = RealWorld.run(SHUTTLE, registry.create(spec), 1);
    run.run(20_000);
    int detected = 0;
    for (int step = 0; step < 5_000; step++) {
      run.step();
      detected += run.network().detected(0);
    }
    return detected;
  }

  private ActionValues values(String state) {
    ToyNetwork network = new ToyNetwork(1, 6);
    ZoomPolicy policy = network.begin(registry.create("sarsa:state=" + state), 1);
    return ((TemporalDifferenceZoomPolicy) policy).q();
  }
}
