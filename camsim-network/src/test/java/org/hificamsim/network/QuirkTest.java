package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Tests each quirk of CamSim: those that are always kept, and those that can be left out. */
class QuirkTest {
  private static final String ACTIVE = "ai_algorithm='active' comm='0'";
  private static final String PASSIVE = "ai_algorithm='passive' comm='0'";
  private static final String FIX = "ai_algorithm='active' comm='3'";

  @Test
  void q3SpeedIsHeadingOfWaypointsNamedByClass() {
    SmallNetwork network = withWaypoints().run(1);
    assertEquals(Math.toRadians(90), network.world().targets().x(0), 1e-12);
  }

  @Test
  void q3OffWaypointsKeepTheirSpeed() {
    SmallNetwork network = withWaypoints().without(Quirk.WAYPOINT_SPEED_IS_HEADING).run(1);
    assertEquals(0.25, network.world().targets().x(0), 1e-12);
  }

  @Test
  void q3DoesNotAffectCoverageStudies() {
    SmallNetwork network = withWaypoints().cameraElement("<zoom>5 10</zoom>").run(1);
    assertEquals(0.25, network.world().targets().x(0), 1e-12);
  }

  private static SmallNetwork withWaypoints() {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, ACTIVE)
        .targetElement(
            "<object features='1' x='0' y='0' heading='90' speed='0.25'"
                + " move='epics.movement.Waypoints'>"
                + "<waypoint x='0' y='0'/><waypoint x='40' y='0'/></object>");
  }

  @Test
  void q5LinksAreFrozenByPolicyNotByGraph() {
    assertEquals(1, linked().run(400).row(399).communication());
  }

  @Test
  void q5PreviousCameraPolicyGivesReverseLinks() {
    String nodes = "<graphnode name='A'><neighbour name='B'/></graphnode>";
    SmallNetwork afterFix =
        new SmallNetwork()
            .camera("A", -30, 0, 5, FIX)
            .camera("B", 0, 0, 10, FIX)
            .still("1", 1, 1)
            .graph(false, nodes)
            .run(2);
    assertEquals(1, afterFix.last().communication(), "B asks A, which lists it");
    SmallNetwork withoutQuirk =
        new SmallNetwork()
            .camera("A", -30, 0, 5, FIX)
            .camera("B", 0, 0, 10, FIX)
            .still("1", 1, 1)
            .graph(false, nodes)
            .without(Quirk.LINKS_FREEZE_BY_POLICY)
            .run(2);
    assertEquals(0, withoutQuirk.last().communication(), "the graph is not static");
  }

  private static SmallNetwork linked() {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, FIX)
        .camera("B", 30, 0, 5, FIX)
        .still("1", 1, 1)
        .graph(false, "<graphnode name='A'><neighbour name='B'/></graphnode>");
  }

  @Test
  void q6FailedCameraNeverComesBack() {
    SmallNetwork network = failing().run(30);
    assertFalse(network.world().cameras().online(0));
    assertEquals("A", network.owners("1.0"), "keeps its targets, which nobody can buy");
  }

  @Test
  void q6OffFailedCameraComesBack() {
    SmallNetwork network = failing().without(Quirk.FAILED_CAMERAS_STAY_OFFLINE).run(8);
    assertFalse(network.world().cameras().online(0));
    assertTrue(network.run(1).world().cameras().online(0));
  }

  @Test
  void q6RestoredCameraStillSeesVanishedTarget() {
    // Offline from step 31 to 38, so the target vanishes meanwhile.
    SmallNetwork network = withVanishingTarget("33").errorLevel(100).run(40);
    assertTrue(network.world().cameras().online(0));
    assertTrue(network.sees(0, 0));
    assertEquals(0, network.last().proportion());
  }

  @Test
  void q6OffRestoredCameraForgetsVanishedTarget() {
    SmallNetwork network =
        withVanishingTarget("3")
            .event("timestep='2' participant='camera' event='error' name='A' duration='3'")
            .without(Quirk.FAILED_CAMERAS_STAY_OFFLINE)
            .run(20);
    assertTrue(network.world().cameras().online(0));
    assertFalse(network.sees(0, 0));
    assertEquals(0, network.last().utility());
    assertEquals(0, network.last().proportion());
  }

  /** A camera next to a target that vanishes at a step. */
  private static SmallNetwork withVanishingTarget(String step) {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, ACTIVE)
        .still("1", 0.5, 0)
        .event("timestep='%s' participant='object' event='error' name='1'".formatted(step));
  }

  private static SmallNetwork failing() {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, ACTIVE)
        .camera("B", 3, 0, 10, ACTIVE)
        .still("1", 0.5, 0)
        .event("timestep='3' participant='camera' event='error' name='A' duration='5'");
  }

  @Test
  void q7AskingOfflineNeighbourCountsAsAttempt() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 0, 0, 10, ACTIVE)
            .camera("B", 30, 0, 5, ACTIVE)
            .camera("C", -30, 0, 5, ACTIVE)
            .still("1", 1, 1)
            .event("timestep='2' participant='camera' event='error' name='B' duration='-1'")
            .run(3);
    assertEquals(2, network.row(1).attempts());
    assertEquals(2, network.row(1).communication());
    assertEquals(2, network.row(2).attempts());
    assertEquals(1, network.row(2).communication());
  }

  @Test
  void q7AcceptsSecondErrorOfOneCamera() {
    SmallNetwork network =
        failing()
            .event("timestep='4' participant='camera' event='error' name='A' duration='-1'")
            .run(6);
    assertFalse(network.world().cameras().online(0));
  }

  @Test
  void q8VanishedTargetStaysOwnedAndAdvertised() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 0, 0, 10, PASSIVE)
            .camera("B", 30, 0, 5, PASSIVE)
            .still("1", 0.5, 0)
            .event("timestep='2' participant='object' event='error' name='1.0'")
            .run(20);
    assertEquals(0, network.row(1).communication());
    assertEquals(1, network.row(19).communication());
    assertEquals("A", network.owners("1.0"));
  }

  @Test
  void q9TargetAtCameraIsInvisible() {
    SmallNetwork network = new SmallNetwork().camera("A", 0, 0, 10, ACTIVE).still("1", 0, 0).run(1);
    assertEquals("", network.owners("1.0"));
  }

  @Test
  void q10RangeOfTwentyBecomesSixteen() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 0, 0, 20, ACTIVE)
            .camera("B", 0, 0, 19.9, ACTIVE)
            .still("1", 17, 0)
            .run(1);
    assertEquals(16.0, network.world().cameras().zoom(0, 0).radius());
    assertEquals("B", network.owners("1.0"));
  }

  @Test
  void q13RangeNearTwentyHasNoUtility() {
    SmallNetwork worthless =
        new SmallNetwork().camera("A", 0, 0, 19, ACTIVE).still("1", 1, 0).run(1);
    assertEquals(0, worthless.last().utility());
    SmallNetwork worthSome =
        new SmallNetwork().camera("A", 0, 0, 10, ACTIVE).still("1", 1, 0).run(1);
    assertTrue(worthSome.last().utility() > 0);
  }

  @Test
  void q15ErrorLevelFailsOnePercentMoreSteps() {
    SmallNetwork never = manyCameras().errorLevel(-1).run(300);
    SmallNetwork often = manyCameras().errorLevel(9).run(300);
    assertEquals(10, online(never));
    assertTrue(online(often) < 10, online(often) + " online");
  }

  private static SmallNetwork manyCameras() {
    SmallNetwork network = new SmallNetwork().still("1", 1, 1);
    for (int i = 0; i < 10; i++) {
      network.camera("C" + i, i, 0, 10, ACTIVE);
    }
    return network;
  }

  private static int online(SmallNetwork network) {
    int online = 0;
    for (int camera = 0; camera < network.world().cameras().count(); camera++) {
      online += network.world().cameras().online(camera) ? 1 : 0;
    }
    return online;
  }

  @Test
  void q17MoveOfEventIsIgnoredOnlyUnderQuirk() {
    assertEquals(0.0, wandering().run(1).world().targets().y(0));
    assertTrue(wandering().without(Quirk.EVENT_MOVE_IGNORED).run(1).world().targets().y(0) != 0);
  }

  private static SmallNetwork wandering() {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, ACTIVE)
        .event(
            "timestep='0' participant='object' event='add' name='1' x='0' y='0' heading='90'"
                + " speed='0' move='epics.movement.Brownian'");
  }

  @Test
  void q19TieGoesToFirstByHashCodeOrElseByList() {
    assertEquals("I", tie("I", "H").without(Quirk.TIES_BY_HASH_CODE).run(2).owners("1.0"));
    assertEquals("H", tie("I", "H").run(2).owners("1.0"), "bucket 3 comes before bucket 6");
  }

  private static SmallNetwork tie(String first, String second) {
    return new SmallNetwork()
        .camera("A", 20, 0, 15, ACTIVE)
        .camera(first, 8, 1, 10, ACTIVE)
        .camera(second, 8, -1, 10, ACTIVE)
        .still("1", 17, 0)
        .event(
            "timestep='1' participant='camera' event='change' name='A' x='-40' y='-40'"
                + " heading='-1' viewing_angle='-1' range='-1'");
  }

  @Test
  void q18ResetCameraNeverAsksAgain() {
    assertEquals(0, lateAttempts(-1), "every camera has failed and was reset");
    assertTrue(lateAttempts(100) > 0, "no camera was reset");
  }

  /** Attempts in the last 50 of 150 steps, in each of which a camera fails and comes back soon. */
  private static long lateAttempts(int resetLevel) {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 0, 0, 10, ACTIVE)
            .camera("B", 3, 0, 10, ACTIVE)
            .still("1", 1, 1)
            .without(Quirk.FAILED_CAMERAS_STAY_OFFLINE)
            .errorLevel(100)
            .resetLevel(resetLevel)
            .run(150);
    long attempts = 0;
    for (int step = 100; step < 150; step++) {
      attempts += network.row(step).attempts();
    }
    return attempts;
  }

  @Test
  void q21AddedCameraDoesNotKnowPresentTargets() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 30, 0, 5, PASSIVE)
            .still("1", 0.5, 0)
            .event(
                "timestep='2' participant='camera' event='add' name='B' x='0' y='0' heading='0'"
                    + " viewing_angle='360' range='10' comm='0'")
            .event(
                "timestep='4' participant='object' event='add' name='2' x='0' y='0.5'"
                    + " heading='0' speed='0'")
            .run(6);
    assertEquals("", network.owners("1.0"));
    assertEquals("B", network.owners("2.0"));
  }
}
