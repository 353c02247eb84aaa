package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.junit.jupiter.api.Test;

/** Tests CamSim's network in a world with walls, with cameras that have optics. */
class OpticsAndWallsTest {
  private static final String ACTIVE = "ai_algorithm='Active' comm='0'";

  /** Gives all cameras the view with the number of the step. */
  private static final class InTurn implements ZoomPolicy {
    @Override
    public String name() {
      return "in-turn";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length; camera++) {
        views[camera] = (int) (network.step() % network.views(camera));
      }
    }
  }

  /** Returns a network of two cameras, of which A is nearer to the only target. */
  private static SmallNetwork nearAndFar() {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, ACTIVE)
        .camera("B", 11, 0, 10, ACTIVE)
        .still("1.0", 5, 0);
  }

  @Test
  void fartherCameraOwnsTargetThatAWallHidesFromTheNearer() {
    assertEquals("A", nearAndFar().run(3).owners("1.0"));
    SmallNetwork walled = nearAndFar().obstacle("<wall x1='2.5' y1='-1' x2='2.5' y2='1'/>").run(3);
    assertFalse(walled.sees(0, 0));
    assertTrue(walled.sees(1, 0));
    assertEquals("B", walled.owners("1.0"));
  }

  @Test
  void translucentWallLowersBid() {
    SmallNetwork open = nearAndFar().run(3);
    SmallNetwork walled =
        nearAndFar()
            .obstacle("<wall x1='2.5' y1='-1' x2='2.5' y2='1' transmittance='0.5'/>")
            .run(3);
    assertEquals(open.confidence(0, 0) / 2, walled.confidence(0, 0));
    assertEquals("B", walled.owners("1.0"));
  }

  @Test
  void targetHidesAnotherIfScenarioHasOcclusion() {
    assertTrue(nearAndFar().still("2.0", 3, 0).run(1).sees(0, 0));
    SmallNetwork hiding = nearAndFar().still("2.0", 3, 0).simulation("occlusion='targets'").run(1);
    assertFalse(hiding.sees(0, 0));
    assertTrue(hiding.sees(0, 1));
  }

  /** A camera that can look north-east, east or south, and a target in each of these directions. */
  private static SmallNetwork turning(ZoomPolicy policy) {
    return new SmallNetwork()
        .policy(policy)
        .cameraElement("<optics name='ptz' hfov='20 40' reach='15' pan='45 90 180'/>")
        .cameraElement(
            "<camera name='A' x='0' y='0' heading='0' optics='ptz' %s/>".formatted(ACTIVE))
        .still("1.0", 5, 5)
        .still("2.0", 5, 0)
        .still("3.0", 0, -5);
  }

  @Test
  void cameraStartsInItsHomeView() {
    SmallNetwork home = turning(Catalogue.load().policies().create("zoom-out")).run(3);
    assertTrue(home.sees(0, 0) && !home.sees(0, 1) && !home.sees(0, 2));
    assertEquals("A", home.owners("1.0"));
  }

  @Test
  void policyTurnsCamera() {
    SmallNetwork turned = turning(new InTurn());
    for (int view = 0; view < 6; view++) {
      turned.run(1);
      for (int target = 0; target < 3; target++) {
        assertEquals(target == view / 2, turned.sees(0, target), "view " + view);
      }
    }
  }

  /**
   * Returns a network of two cameras that look at each other in views 0 and 1 and apart in 2 and 3.
   */
  private static SmallNetwork facing(String attributes) {
    String camera = "<camera name='%s' x='%s' y='0' heading='%s' optics='ptz' %s/>";
    return new SmallNetwork()
        .policy(new InTurn())
        .cameraElement(
            "<optics name='ptz' law='constant-area' hfov='20 80' reach='12' pan='0 180' %s/>"
                .formatted(attributes))
        .cameraElement(camera.formatted("A", 0, 90, ACTIVE))
        .cameraElement(camera.formatted("B", 10, 270, ACTIVE))
        .still("1.0", 5, 0);
  }

  @Test
  void overlapFollowsRangeOfCurrentView() {
    SmallNetwork network = facing("").run(8);
    assertEquals(network.row(0).overlap(), network.row(4).overlap());
    assertTrue(network.row(0).overlap() > network.row(1).overlap(), "12 m reach farther than 6 m");
  }

  @Test
  void cameraMovingBlindlyHasNoOverlap() {
    SmallNetwork network = facing("pan_speed='45'").run(4);
    assertEquals(Cameras.NO_VIEW, network.world().cameras().seeing(0));
    assertEquals(0, network.last().overlap());
    assertEquals(0, network.world().cameras().range(0));
  }

  private static SmallNetwork zooming(String optics) {
    return new SmallNetwork()
        .policy(Catalogue.load().policies().create("zoom-out"))
        .cameraElement(optics)
        .cameraElement(
            "<camera name='A' x='0' y='0' heading='0' viewing_angle='90' range='10' optics='ptz'"
                + " ai_algorithm='BanditZoom' comm='0'/>")
        .bandit(BanditAlgorithm.UCB1)
        .still("1.0", 5, 0);
  }

  @Test
  void rejectsLensWithZoomBandit() {
    SmallNetwork lens = zooming("<optics name='ptz' hfov='30' pan='0 90'/>");
    InputException error = assertThrows(InputException.class, () -> lens.run(1));
    assertEquals(
        "camera 'A': optics: expected none, or law=\"round\", where the schedule is BanditZoom,"
            + " which sets ranges",
        error.getMessage());
  }

  @Test
  void banditSetsRangeOfTurningRoundCamera() {
    SmallNetwork round = zooming("<optics name='ptz' law='round' pan='90 180'/>").run(60);
    Cameras cameras = round.world().cameras();
    assertTrue(cameras.range(0) > 0 && cameras.range(0) != 10, cameras.range(0) + " m");
    assertEquals(2, cameras.views(0));
    assertTrue(cameras.range(0) < 5 || round.sees(0, 0));
  }
}
