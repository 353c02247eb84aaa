package org.hificamsim.agents.baseline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.TreeSet;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests baselines with one camera at the origin, which looks along +y and has five pan angles with
 * two zoom levels each: views 0 and 1 at -60 degrees, 4 (20 degrees wide) and 5 (60 degrees wide)
 * ahead.
 */
class TurningBaselinesTest {
  private static final String LENS = "<optics name='o' hfov='20 60' reach='15' pan='-60:60:30'/>";
  private static final String SLOW = LENS.replace("/>", " pan_speed='15'/>");

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @Test
  void zoomOutAndZoomInLookAhead() {
    assertViews("zoom-out", LENS, "5 5 5");
    assertViews("zoom-in", LENS, "4 4 4");
  }

  @Test
  void looksAheadAtThePanAngleNearestToTheHeading() {
    assertViews("zoom-out", LENS.replace("-60:60:30", "-50 -10 30"), "3");
    assertViews("zoom-in", LENS.replace("-60:60:30", "20 40"), "0");
  }

  @Test
  void fixedLevelsUseGivenPanAnglesOrLookAhead() {
    assertViews("fixed", LENS, "4 4");
    assertViews("fixed:1", LENS, "5 5");
    assertViews("fixed:1,pans=4", LENS, "9 9");
    assertViews("fixed:levels=0,pans=0", LENS, "0 0");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          fixed:2          | level of camera 'a' is 2, expected 0 (narrowest) to 1 (widest)
          fixed:pans=5     | pan of camera 'a' is 5, expected 0 (first pan angle) to 4 (last)
          fixed:1,pans=1,2 | pans has 2 values, expected 1 for all cameras or 1, one for each
          """)
  void rejectsLevelsAndPansThatCamerasDoNotHave(String spec, String reason) {
    ZoomPolicy policy = registry.create(spec);
    InputException error =
        assertThrows(InputException.class, () -> RealWorld.run(world(LENS), policy, 1));
    assertEquals("policy fixed: " + reason, error.getMessage());
  }

  @Test
  void numbersWithoutKeyAreLevels() {
    InputException error =
        assertThrows(InputException.class, () -> registry.create("fixed:2,levels=1"));
    assertEquals(
        "policy fixed: unknown option '2', expected one of levels, pans", error.getMessage());
  }

  @Test
  void randomTakesEveryView() {
    int[] views = views(run("random", LENS), 300);
    assertEquals(10, new TreeSet<>(Arrays.stream(views).boxed().toList()).size());
  }

  @Test
  void patrolSweepsBackAndForth() {
    assertViews("patrol", LENS, "5 7 9 7 5 3 1 3 5");
    assertViews("patrol:zoom=narrowest", LENS, "4 6 8 6");
    assertViews("patrol:dwell=3", LENS, "5 5 5 7 7 7 9 9 9 7");
  }

  @Test
  void patrolStaysIfTheCameraCannotTurn() {
    assertViews("patrol", LENS.replace("pan='-60:60:30'", ""), "1 1 1");
  }

  @Test
  void patrolDwellsAfterItHasArrived() {
    assertSeeing("patrol", SLOW, "5 -1 7 -1 9 -1 7");
    assertSeeing("patrol:dwell=2", SLOW, "5 5 -1 7 7 -1 9 9");
  }

  @Test
  void randomCompletesItsMoves() {
    Simulation run = run("random", SLOW);
    int arrivals = 0;
    for (int step = 0; step < 200; step++) {
      int before = run.network().view(0);
      boolean moving = run.network().seeing(0) < 0;
      run.step();
      assertTrue(!moving || before == run.network().view(0), "step " + step);
      arrivals += run.network().seeing(0) >= 0 ? 1 : 0;
    }
    assertTrue(arrivals > 40, arrivals + " steps in which it saw");
  }

  @Test
  void trackerCentresATargetAndZoomsIn() {
    assertViews("tracker", LENS, "6 6 6", at(25, 10));
    assertViews("tracker", LENS, "2 2 2", at(-25, 10));
  }

  @Test
  void trackerKeepsAMarginToTheEdgeOfItsPicture() {
    assertViews("tracker", LENS, "5 5", at(9, 10));
    assertViews("tracker:margin=0.05", LENS, "4 4", at(9, 10));
    assertViews("tracker", LENS, "5 5", at(0, 14));
  }

  @Test
  void trackerStaysIfNoZoomHasTheTargetWithAMargin() {
    assertViews("tracker", LENS, "5 5", at(25, 14));
  }

  @Test
  void trackerSearchesWithTheGivenZoomLevel() {
    assertViews("tracker:search=narrowest", LENS, "4 6 8 6 4");
    assertViews("tracker:search=narrowest,dwell=2", LENS, "4 4 6 6 8");
  }

  @Test
  void trackerKeepsTheNearestTarget() {
    assertViews("tracker", LENS, "6 6", at(-25, 11), at(25, 10));
    assertViews("tracker", LENS, "2 2", at(-25, 10), at(25, 11));
  }

  @Test
  void trackerFollowsATargetAcrossAllPanAngles() {
    Simulation run =
        run("tracker", LENS, "<object features='1' x='-2' y='5' heading='90' speed='1'/>");
    for (int step = 0; step < 12; step++) {
      run.step();
      assertEquals(1, run.network().detected(0), "step " + step);
    }
    assertEquals(8, run.network().view(0), "far on the right, narrow");
  }

  @Test
  void trackerSearchesWhileItSeesNothing() {
    assertViews("tracker", LENS, "5 7 9 7 5");
    assertViews("tracker", LENS, "5 7 9 8 8", at(62, 10));
  }

  @Test
  void trackerDoesNotKnowOfATargetBehindAWall() {
    String wall = "<wall x1='-9' y1='5' x2='9' y2='5'/>";
    assertViews("tracker", LENS + wall, "5 7 9 7", at(0, 10));
  }

  /** The target walks to the right, behind a wall that begins right of the camera. */
  @Test
  void trackerWidensWhenItLosesItsTarget() {
    String wall = "<wall x1='0.6' y1='5' x2='19' y2='5'/>";
    String target = "<object features='1' x='0' y='10' heading='90' speed='1'/>";
    assertViews("tracker", LENS + wall, "4 4 5 7 9", target);
  }

  @Test
  void trackerTurnsBackToATargetSeenDuringAMove() {
    String lens = SLOW.replace("speed='15'", "speed='2'").replace("/>", " moving='sees'/>");
    Simulation run =
        run("tracker", lens, "<object features='1' x='9' y='9.5' heading='270' speed='3'/>");
    assertEquals("5 7 7 4", joined(views(run, 4)), "at 43, 32, 18 and 0 degrees");
  }

  @Test
  void greedyTakesTheViewWithMostTargets() {
    assertViews("greedy", LENS, "3 3", at(-5, 10), at(-50, 10), at(-55, 10), at(25, 10));
    assertViews("greedy", LENS, "7 7", at(-5, 10), at(25, 10), at(45, 10), at(50, 10));
  }

  @Test
  void greedyDoesNotCountTargetsBehindAWall() {
    String wall = "<wall x1='-12' y1='6' x2='-1' y2='6'/>";
    assertViews("greedy", LENS + wall, "5 5", at(-20, 10), at(-25, 10), at(-45, 10), at(5, 10));
  }

  @Test
  void greedyBreaksTiesByStayingThenWidestThenNearest() {
    assertViews("greedy", LENS, "5 5", at(2, 10));
    assertViews("greedy", LENS, "7 7", at(47, 10));
    assertViews("greedy:among=all", LENS, "7 7", at(47, 10));
    assertViews("greedy", LENS, "5 5");
  }

  @Test
  void greedyChoosesAmongReachedViewsByDefault() {
    assertViews("greedy", LENS, "5 5", at(-5, 10), at(75, 10), at(80, 10));
    assertViews("greedy:among=all", LENS, "9 9", at(-5, 10), at(75, 10), at(80, 10));
  }

  @Test
  void greedyMovesTowardsTargetsBeyondTheReachedViews() {
    assertSeeing("greedy", SLOW, "-1 -1 -1 9 9", at(75, 10));
  }

  /** Returns a target at an angle to the right of the camera's heading, in degrees. */
  private static String at(double angleDegrees, double distance) {
    double angle = Math.toRadians(angleDegrees);
    return "<object features='"
        + (1000 + angleDegrees + distance)
        + "' x='"
        + distance * Math.sin(angle)
        + "' y='"
        + distance * Math.cos(angle)
        + "' heading='0' speed='0'/>";
  }

  private void assertViews(String policy, String lens, String expected, String... targets) {
    int[] views = views(run(policy, lens, targets), expected.split(" ").length);
    assertEquals(expected, joined(views));
  }

  private void assertSeeing(String policy, String lens, String expected, String... targets) {
    Simulation run = run(policy, lens, targets);
    int[] seeing = new int[expected.split(" ").length];
    for (int step = 0; step < seeing.length; step++) {
      run.step();
      seeing[step] = run.network().seeing(0);
    }
    assertEquals(expected, joined(seeing));
  }

  private static String joined(int[] numbers) {
    return String.join(" ", Arrays.stream(numbers).mapToObj(String::valueOf).toList());
  }

  private static int[] views(Simulation run, int steps) {
    int[] views = new int[steps];
    for (int step = 0; step < steps; step++) {
      run.step();
      views[step] = run.network().view(0);
    }
    return views;
  }

  private Simulation run(String policy, String lens, String... targets) {
    return RealWorld.run(world(lens, targets), registry.create(policy), 1);
  }

  private static String world(String lens, String... targets) {
    return lens
        + "<camera name='a' x='0' y='0' heading='0' viewing_angle='60' range='15' optics='o'/>"
        + String.join("", targets);
  }
}
