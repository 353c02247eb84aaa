package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests a camera with two levels at -40, 0 and 40 degrees, whose moves take no time by default. */
class CamerasTest {
  private static final int LEFT = 1;
  private static final int AHEAD = 3;

  private Cameras cameras;

  @BeforeEach
  void mount() {
    cameras = cameras(Optional.empty());
  }

  private static Cameras cameras(Optional<Double> panSpeed) {
    OpticsSpec optics =
        new OpticsSpec("lens")
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(30.0, 60.0))
            .with(OpticsSpec.REACH, 7)
            .with(OpticsSpec.PANS, List.of(-40.0, 0.0, 40.0))
            .with(OpticsSpec.PAN_SPEED, panSpeed);
    return new TestScenario()
        .camera(TestScenario.camera("a", 0, 0, 0, optics))
        .target(1, 1)
        .world()
        .cameras();
  }

  @Test
  void revisionChangesOnlyWithTheView() {
    int revision = cameras.viewRevision();
    cameras.turnTo(0, AHEAD);
    assertEquals(revision, cameras.viewRevision(), "the view that it had");
    cameras.turnTo(0, LEFT);
    assertNotEquals(revision, cameras.viewRevision());
  }

  @Test
  void aimingTurnsChosenViewUntilNextTurn() {
    cameras.aim(0, LEFT, 0.25);
    assertEquals(LEFT, cameras.view(0));
    assertEquals(0.25, cameras.pan(0, LEFT));
    assertEquals(Math.toRadians(-40), cameras.pan(0, LEFT - 1), "another view");
    assertEquals(0.25, cameras.pose(0, LEFT).heading(), 1e-15);
    assertEquals(0, cameras.pose(0, AHEAD).heading(), 1e-15);
    int revision = cameras.viewRevision();
    cameras.turnTo(0, LEFT);
    assertEquals(Math.toRadians(-40), cameras.pan(0, LEFT), 1e-15);
    assertEquals(Math.toRadians(-40), cameras.pose(0, LEFT).heading(), 1e-15);
    assertNotEquals(revision, cameras.viewRevision());
  }

  @Test
  void aimingAgainChangesRevision() {
    cameras.aim(0, AHEAD, 0.25);
    int revision = cameras.viewRevision();
    cameras.aim(0, AHEAD, 0.5);
    assertNotEquals(revision, cameras.viewRevision());
    assertEquals(0.5, cameras.pan(0, AHEAD));
  }

  @Test
  void tiltsOfOpticsAddToTiltOfCamera() {
    for (List<Double> offs : List.of(List.of(0.0), List.of(20.0), List.of(-30.0, 20.0))) {
      OpticsSpec optics =
          new OpticsSpec("lens")
              .with(OpticsSpec.ANGLES_OF_VIEW, List.of(30.0, 60.0))
              .with(OpticsSpec.TILTS, offs);
      Cameras tilting =
          new TestScenario()
              .camera(
                  TestScenario.camera("a", 0, 0, 0, optics)
                      .with(CameraSpec.Z, 3.0)
                      .with(CameraSpec.TILT, 10.0))
              .target(1, 1)
              .world()
              .cameras();
      int last = tilting.views(0) - 1;
      double off = offs.get(offs.size() - 1);
      assertEquals(Math.toRadians(10 + off), tilting.zoom(0, last).vertical().tilt(), 1e-15);
    }
  }

  @Test
  void rangeIsZeroWhileMoving() {
    Cameras slow = cameras(Optional.of(20.0));
    assertEquals(7, slow.range(0), 1e-9);
    int revision = slow.viewRevision();
    slow.turnTo(0, LEFT);
    slow.advance();
    assertEquals(0, slow.range(0));
    int onItsWay = slow.viewRevision();
    assertNotEquals(revision, onItsWay);
    slow.advance();
    assertEquals(7, slow.range(0), 1e-9);
    assertNotEquals(onItsWay, slow.viewRevision());
  }
}
