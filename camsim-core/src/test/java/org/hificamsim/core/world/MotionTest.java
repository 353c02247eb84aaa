package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.Moving;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;

/** Tests moves of a camera with pan angles of -60, 0 and 60 degrees and levels 0 to 2. */
class MotionTest {
  private static final int AHEAD = 5;
  private static final int LEFT = 2;
  private static final int RIGHT = 8;
  private static final int RIGHT_NARROW = 6;

  @Test
  void startsAheadAtWidestView() {
    Cameras cameras = cameras(Optional.empty(), 0, Moving.BLIND, 1);
    assertEquals(9, cameras.views(0));
    assertEquals(3, cameras.zooms(0));
    assertEquals(AHEAD, cameras.view(0));
    assertEquals(AHEAD, cameras.seeing(0));
    assertEquals(Math.toRadians(58), cameras.zoom(0, AHEAD).viewingAngle());
    assertEquals(Math.toRadians(60), cameras.pan(0, RIGHT));
    assertEquals(Math.toRadians(150), cameras.pose(0, RIGHT).heading(), 1e-12, "90 and 60 degrees");
  }

  @Test
  void instantMoveIsVisibleAtOnce() {
    Cameras cameras = cameras(Optional.empty(), 0, Moving.BLIND, 1);
    turn(cameras, RIGHT_NARROW);
    assertEquals(RIGHT_NARROW, cameras.seeing(0));
  }

  @Test
  void moveWithinStepIsVisibleInThatStep() {
    Cameras cameras = cameras(Optional.of(30.0), 0, Moving.BLIND, 2);
    assertTrue(cameras.reaches(0, RIGHT));
    turn(cameras, RIGHT);
    assertEquals(RIGHT, cameras.seeing(0));
  }

  @Test
  void longMoveIsBlindUntilItEnds() {
    Cameras cameras = cameras(Optional.of(20.0), 0, Moving.BLIND, 1);
    assertFalse(cameras.reaches(0, RIGHT));
    turn(cameras, RIGHT);
    assertEquals(Cameras.NO_VIEW, cameras.seeing(0));
    turn(cameras, RIGHT);
    assertEquals(Cameras.NO_VIEW, cameras.seeing(0));
    assertTrue(cameras.reaches(0, RIGHT), "20 degrees are left");
    turn(cameras, RIGHT);
    assertEquals(RIGHT, cameras.seeing(0));
  }

  @Test
  void seesNearestViewWhileMoving() {
    Cameras cameras = cameras(Optional.of(25.0), 0, Moving.SEES, 1);
    turn(cameras, RIGHT);
    assertEquals(AHEAD, cameras.seeing(0), "at 25 degrees");
    turn(cameras, RIGHT);
    assertEquals(RIGHT, cameras.seeing(0), "at 50 degrees");
    assertTrue(cameras.moving(0), "though it has not arrived");
    turn(cameras, RIGHT);
    assertFalse(cameras.moving(0));
  }

  @Test
  void slowZoomPassesLevels() {
    Cameras cameras = cameras(Optional.of(1000.0), 4, Moving.SEES, 1);
    turn(cameras, RIGHT_NARROW);
    assertEquals(7, cameras.seeing(0), "level 1.5 is nearer to 1 than to 0, and not nearer to 2");
    assertTrue(cameras.reaches(0, 7));
    assertFalse(cameras.reaches(0, RIGHT_NARROW));
  }

  @Test
  void reversesMoveFromCurrentAngle() {
    Cameras cameras = cameras(Optional.of(20.0), 0, Moving.BLIND, 1);
    turn(cameras, RIGHT);
    turn(cameras, LEFT);
    assertEquals(Cameras.NO_VIEW, cameras.seeing(0), "at 0 degrees, on its way to -60");
    turn(cameras, AHEAD);
    assertEquals(AHEAD, cameras.seeing(0));
  }

  @Test
  void sumsFractionsOfSecondsExactly() {
    Cameras cameras = cameras(Optional.of(60.0), 0, Moving.BLIND, 0.2);
    for (int step = 0; step < 4; step++) {
      turn(cameras, RIGHT);
      assertEquals(Cameras.NO_VIEW, cameras.seeing(0));
    }
    turn(cameras, RIGHT);
    assertEquals(RIGHT, cameras.seeing(0));
  }

  @Test
  void jumpArrivesAtOnce() {
    Cameras cameras = cameras(Optional.of(1.0), 100, Moving.BLIND, 1);
    cameras.jumpTo(0, RIGHT_NARROW);
    cameras.advance();
    assertEquals(RIGHT_NARROW, cameras.seeing(0));
  }

  @Test
  void reachesAdjacentViewsIfMovesAreInstant() {
    Cameras cameras = cameras(Optional.empty(), 0, Moving.BLIND, 1);
    assertTrue(cameras.reaches(0, RIGHT));
    assertTrue(cameras.reaches(0, 1), "one level and one angle");
    assertFalse(cameras.reaches(0, 3), "two levels");
  }

  private static void turn(Cameras cameras, int view) {
    cameras.turnTo(0, view);
    cameras.advance();
  }

  private static Cameras cameras(
      Optional<Double> panSpeed, double zoomTime, Moving moving, double stepTime) {
    OpticsSpec optics =
        new OpticsSpec("ptz")
            .with(OpticsSpec.PIXELS, 640)
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(8.0, 25.0, 58.0))
            .with(OpticsSpec.PANS, List.of(-60.0, 0.0, 60.0))
            .with(OpticsSpec.PAN_SPEED, panSpeed)
            .with(OpticsSpec.ZOOM_TIME, zoomTime)
            .with(OpticsSpec.MOVING, moving);
    return new TestScenario()
        .camera(TestScenario.camera("a", 0, 0, 90, optics))
        .target(1, 1)
        .stepTime(stepTime)
        .world()
        .cameras();
  }
}
