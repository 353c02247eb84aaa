package org.hificamsim.agents.voting;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import org.hificamsim.agents.baseline.AheadZoomPolicy;
import org.hificamsim.agents.baseline.PatrolZoomPolicy;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class ViewTranslationTest {
  private static final String LONG = "<optics name='long' hfov='10 20 40' pan='-30 0 30'/>";
  private static final String SHORT = "<optics name='short' hfov='15 80' pan='-45:45:15'/>";
  private static final String ROUND = "<optics name='round' law='round' pan='0 20'/>";
  private static final String ZOOMS = "<zoom>2 4 6 8 10</zoom>";

  @Test
  void equalViewsStayTheSame() {
    assertEquals("0 1 2 3 4 5 6 7 8", translated(LONG, "long", "long"));
    assertEquals("0 1 2 3 4 5 6 7 8 9", translated(ROUND + ZOOMS, "round", "round"));
  }

  @Test
  void takesNearestPanAngleAndAngleOfView() {
    assertEquals("2 2 3 6 6 7 10 10 11", translated(LONG + SHORT, "long", "short"));
    assertEquals("1 2 1 2 1 2 4 5 4 5 7 8 7 8", translated(LONG + SHORT, "short", "long"));
  }

  @Test
  void comparesLevelsWithoutLensByPosition() {
    assertEquals("3 4 4 5 5 6 7 7 8 8", translated(LONG + ROUND + ZOOMS, "round", "long"));
    assertEquals("0 2 4 0 2 4 5 7 9", translated(LONG + ROUND + ZOOMS, "long", "round"));
  }

  /** The neighbour answers for its nearest state; its view is translated back. */
  @Test
  void translatesQueryAndAnswerOfANeighbour() {
    QbSarsaZoomPolicy policy =
        new QbSarsaZoomPolicy(Options.parse("qb-sarsa", "epsilon=0,own-vote=no"));
    Simulation run =
        RealWorld.run(world(LONG + SHORT, "optics='long'", "optics='short'"), policy, 1);
    ActionValues values = policy.q();
    values.set(1, values.state(1, 7, 0), 12, 1);
    run.step();
    assertEquals(7, run.network().view(0), "asked in view 5, which is 7 there; 12 there is 7 here");
  }

  private static String translated(String optics, String from, String to) {
    NetworkView network = network(optics, "optics='" + from + "'", "optics='" + to + "'");
    ViewTranslation translation = new ViewTranslation(network, null); // asks no neighbour
    return String.join(
        " ",
        IntStream.range(0, network.views(0))
            .mapToObj(view -> String.valueOf(translation.view(0, 1, view)))
            .toList());
  }

  private static NetworkView network(String optics, String first, String second) {
    return RealWorld.run(
            world(optics, first, second),
            new AheadZoomPolicy("zoom-out", PatrolZoomPolicy.Zoom.WIDEST),
            1)
        .network();
  }

  private static String world(String optics, String first, String second) {
    String camera = "x='0' y='0' heading='0' viewing_angle='60' range='10' ";
    return optics
        + "<camera name='a' "
        + camera
        + first
        + "/><camera name='b' "
        + camera
        + second
        + "/>";
  }
}
