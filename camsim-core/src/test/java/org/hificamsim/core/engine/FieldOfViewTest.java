package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Assume;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FieldOfViewTest {
  private static final double BORDER = 1e-7;

  /** The same question asked of bearings instead of a scalar product. */
  @Property(tries = 2000, edgeCases = EdgeCasesMode.NONE)
  void agreesWithBearings(
      @ForAll @DoubleRange(min = -10, max = 10) double x,
      @ForAll @DoubleRange(min = -10, max = 10) double y,
      @ForAll @DoubleRange(min = -10, max = 10) double cameraX,
      @ForAll @DoubleRange(min = -10, max = 10) double cameraY,
      @ForAll @DoubleRange(min = -720, max = 720) double heading,
      @ForAll @DoubleRange(min = 0.1, max = 360) double angle,
      @ForAll @DoubleRange(min = 0, max = 19) double range) {
    double distance = Math.hypot(x - cameraX, y - cameraY);
    double bearing = Math.toDegrees(Math.atan2(x - cameraX, y - cameraY));
    double off = Math.abs(Math.IEEEremainder(bearing - heading, 360));
    Assume.that(distance > BORDER);
    Assume.that(Math.abs(off - angle / 2) > BORDER && Math.abs(distance - range) > BORDER);
    FieldOfView view =
        view(TestScenario.camera("a", cameraX, cameraY, heading, angle, range), x, y);
    boolean within = off < angle / 2;
    assertEquals(within, view.withinAngle(0, 0, 0));
    assertEquals(within && distance < range, view.contains(0, 0, 0));
    assertEquals(distance * distance, view.squaredDistance(0, 0), 1e-12 * distance * distance);
    if (off > 1e-3 && off < 179.9) {
      assertEquals(Math.toRadians(off), view.offAxis(0, 0), 1e-9);
    }
  }

  @Property
  void allRoundSeesEveryBearing(
      @ForAll @DoubleRange(min = -180, max = 180) double bearing,
      @ForAll @DoubleRange(min = -720, max = 720) double heading) {
    double x = 3 * Math.sin(Math.toRadians(bearing));
    double y = 3 * Math.cos(Math.toRadians(bearing));
    assertTrue(view(TestScenario.camera("a", 0, 0, heading, 360, 5), x, y).contains(0, 0, 0));
  }

  @Test
  void theRadiusItselfIsInside() {
    CameraSpec camera = TestScenario.camera("a", 0, 0, 0, 360, 5);
    assertTrue(view(camera, 3, 4).contains(0, 0, 0));
    assertTrue(view(camera, 0, 5).contains(0, 0, 0));
    assertFalse(view(camera, 0, Math.nextUp(5.0)).contains(0, 0, 0));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 90, 180, 270, 359.9, 360})
  void aTargetOnTheCameraIsInsideWithoutAnAngle(double angle) {
    FieldOfView view = view(TestScenario.camera("a", 2, 3, 45, angle, 5), 2, 3);
    assertTrue(view.contains(0, 0, 0));
    assertTrue(Double.isNaN(view.offAxis(0, 0)));
    assertEquals(0, view.squaredDistance(0, 0));
  }

  @Test
  void aReachOfNothingHoldsTheCamerasOwnPositionAlone() {
    CameraSpec camera = TestScenario.camera("a", 2, 3, 45, 360, 0);
    assertTrue(view(camera, 2, 3).contains(0, 0, 0));
    assertFalse(view(camera, 2, Math.nextUp(3.0)).contains(0, 0, 0));
  }

  @Test
  void anglesAboveAHalfTurnLeaveOutAWedgeBehind() {
    CameraSpec camera = TestScenario.camera("a", 0, 0, 0, 300, 5);
    assertTrue(view(camera, 0, 1).contains(0, 0, 0));
    assertTrue(view(camera, 1, 0).contains(0, 0, 0));
    assertTrue(view(camera, 1, -1).contains(0, 0, 0));
    assertFalse(view(camera, 0.5, -1).contains(0, 0, 0));
    assertFalse(view(camera, 0, -1).contains(0, 0, 0));
  }

  private static FieldOfView view(CameraSpec camera, double x, double y) {
    World world = new TestScenario().camera(camera).target(x, y).world();
    return new FieldOfView(world.cameras(), world.targets());
  }
}
