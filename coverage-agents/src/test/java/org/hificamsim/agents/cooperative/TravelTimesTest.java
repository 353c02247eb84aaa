package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.way.TravelTimes;
import org.junit.jupiter.api.Test;

class TravelTimesTest {
  private static final String SITE =
      "<cameras><optics name='dome' law='pinhole' pixels='1920' hfov='60 30 15' reach='25'"
          + " pan='-90:90:30' pan_speed='25' zoom_time='5'/><camera name='a' x='-19' y='-19'"
          + " heading='45' optics='dome'/></cameras>";

  @Test
  void agreesWithStepsFromThePresentView() {
    Simulation simulation =
        RealWorld.run(SITE, new CooperativeZoomPolicy(Options.none("cooperative"), false), 1);
    simulation.run(3);
    NetworkView network = simulation.network();
    TravelTimes times = TravelTimes.of(network, 0);
    int views = network.views(0);
    int longest = 0;
    assertTrue(!network.moving(0), "still on its way");
    for (int view = 0; view < views; view++) {
      int steps = times.blindSteps(network.view(0), view);
      assertEquals(network.stepsTo(0, view), steps, "view " + view);
      longest = Math.max(longest, steps);
    }
    assertTrue(longest > 1, "all views are near");
  }
}
