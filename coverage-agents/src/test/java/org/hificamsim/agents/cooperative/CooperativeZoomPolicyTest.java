package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CooperativeZoomPolicyTest {
  private static final String SITE =
      "<obstacles><wall x1='-5' y1='-20' x2='-5' y2='5'/><pillar x='8' y='3'"
          + " radius='1'/></obstacles><cameras><optics name='dome' law='pinhole' pixels='1920'"
          + " hfov='60 30 15' reach='25' pan='-90:90:30' pan_speed='60' zoom_time='2'/><camera"
          + " name='a' x='-19' y='-19' heading='45' optics='dome'/><camera name='b' x='19' y='-19'"
          + " heading='315' optics='dome'/><camera name='c' x='0' y='19' heading='180'"
          + " optics='dome'/></cameras><objects>"
          + target(1, -15, 0)
          + target(2, 10, 10)
          + target(3, 15, -10)
          + target(4, 0, 0)
          + "</objects>";

  private static String target(int name, int x, int y) {
    return "<object features='"
        + name
        + "' x='"
        + x
        + "' y='"
        + y
        + "' heading='0' speed='1.2' move='RandomWaypoint'/>";
  }

  @TestFactory
  Stream<DynamicNode> everyOptionKeepsTheContract() {
    return Stream.of(
            "agree=cbba",
            "agree=log-linear",
            "agree=max-sum",
            "agree=none",
            "map=none",
            "learn=none",
            "learn=bandit",
            "learn=sarsa")
        .map(
            options ->
                DynamicContainer.dynamicContainer(
                    options, new ZoomPolicyContract(() -> policy(options, false), false).tests()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"greedy", "cbba", "log-linear", "max-sum", "none"})
  void separateMindsChooseAsASharedOneOverAPerfectChannel(String rule) {
    List<Integer> sharedMind = views(policy("agree=" + rule, false), SITE);
    assertEquals(sharedMind, views(policy("agree=" + rule, true), SITE));
    assertTrue(sharedMind.stream().distinct().count() > 3, "hardly ever moved: " + sharedMind);
  }

  /** Only one camera sees the target; the other one learns of it and covers it, too. */
  @Test
  void cameraTurnsToTargetThatAnotherOneSees() {
    String site =
        "<cameras><optics name='fixed' law='pinhole' pixels='1920' hfov='60' reach='40'/>"
            + "<optics name='dome' law='pinhole' pixels='1920' hfov='20' reach='40'"
            + " pan='-90:90:15' pan_speed='90'/>"
            + "<camera name='a' x='-19' y='0' heading='90' optics='fixed'/>"
            + "<camera name='b' x='19' y='-19' heading='315' optics='dome'/></cameras>"
            + "<objects><object features='1' x='0' y='1' heading='0' speed='0'/></objects>";
    Simulation simulation = RealWorld.run(site, policy("search=0", false), 1);
    simulation.run(5);
    assertEquals(2, simulation.network().coverage(0));
  }

  @Test
  void coversAboutAsMuchWhenReportsDoNotIdentifyTargets() {
    double identified = covered("identity=known");
    double unidentified = covered("identity=none");
    assertTrue(identified > 100, identified + " steps covered of 4 targets in 200 steps");
    assertEquals(identified, unidentified, 0.1 * identified);
  }

  private static double covered(String options) {
    Simulation simulation = RealWorld.run(SITE, policy(options, false), 7);
    double covered = 0;
    for (int step = 0; step < 200; step++) {
      simulation.step();
      for (int target = 0; target < simulation.network().targets(); target++) {
        covered += simulation.network().coverage(target) > 0 ? 1 : 0;
      }
    }
    return covered;
  }

  @Test
  void movesLessWhenItHoldsViews() {
    long free = changes("hold=0");
    long held = changes("hold=0.2");
    assertTrue(held < free / 2, held + " changes of view instead of " + free);
    assertTrue(held > 0, "never moved");
  }

  private static long changes(String options) {
    List<Integer> views = views(policy(options, false), SITE);
    return IntStream.range(3, views.size())
        .filter(i -> !views.get(i).equals(views.get(i - 3)))
        .count();
  }

  @Test
  void maxSumRejectsReportsThatDoNotIdentifyTargets() {
    InputException error =
        assertThrows(
            InputException.class,
            () -> RealWorld.run(SITE, policy("agree=max-sum,identity=none", false), 1));
    assertTrue(error.getMessage().contains("identity"), error.getMessage());
  }

  /** A wall that is not on the map hides a target from one of two cameras. */
  @Test
  void learnsThatItSeesLessThanTheMapPromises() {
    LearnedSight learnedSight = new LearnedSight(true, new Grid(0, 0, 1, 10, 10), 2);
    for (int step = 0; step < 20; step++) {
      learnedSight.learn(0, 3.5, 3.5, 1, false);
      learnedSight.learn(1, 3.5, 3.5, 1, true);
    }
    assertEquals(3 / 23.0, learnedSight.share(0, 3.5, 3.5), 1e-12);
    assertEquals(1, learnedSight.share(1, 3.5, 3.5), 1e-12);
    assertEquals(1, learnedSight.share(0, 8.5, 3.5), 1e-12);
  }

  @Test
  void rejectsMissingMapFile() {
    InputException error =
        assertThrows(InputException.class, () -> policy("map=no-such-file.xml", false));
    assertTrue(error.getMessage().contains("no-such-file.xml"), error.getMessage());
  }

  @Test
  void countsReportsAndChoicesAsMessages() {
    CooperativeZoomPolicy policy = policy("agree=none", false);
    RealWorld.run(SITE, policy, 1).run(10);
    assertEquals(3 * 10, policy.messages());
    CooperativeZoomPolicy inTurn = policy("", false);
    RealWorld.run(SITE, inTurn, 1).run(10);
    assertTrue(inTurn.messages() >= 2 * 3 * 10, inTurn.messages() + " messages");
    assertTrue(inTurn.bits() > policy.bits());
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void reportsWhichCamerasReceivedMessages(boolean individual) {
    CooperativeZoomPolicy policy = policy("", individual);
    Simulation simulation = RealWorld.run(SITE, policy, 1);
    simulation.run(9);
    long before = policy.messages();
    simulation.step();
    MessageCounter counter = new MessageCounter();
    policy.believe(0, counter);
    assertEquals(policy.messages() - before, counter.messages);
    assertEquals(List.of("0 1", "0 2", "1 0", "1 2", "2 0", "2 1"), counter.received);
  }

  private static final class MessageCounter implements BeliefListener {
    private final List<String> received = new ArrayList<>();
    private int messages;

    @Override
    public void followed(double x, double y, double weight, double spread) {}

    @Override
    public void unseen(double x, double y, double expected) {}

    @Override
    public void sent(int camera, int sent) {
      messages += sent;
    }

    @Override
    public void received(int from, int to) {
      received.add(from + " " + to);
    }
  }

  private static CooperativeZoomPolicy policy(String options, boolean individual) {
    return new CooperativeZoomPolicy(
        options.isEmpty() ? Options.none("cooperative") : Options.parse("cooperative", options),
        individual);
  }

  private static List<Integer> views(CooperativeZoomPolicy policy, String site) {
    Simulation simulation = RealWorld.run(site, policy, 7);
    List<Integer> views = new ArrayList<>();
    for (int step = 0; step < 200; step++) {
      simulation.step();
      for (int camera = 0; camera < simulation.network().cameras(); camera++) {
        views.add(simulation.network().view(camera));
      }
    }
    return views;
  }
}
