package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.hificamsim.agents.baseline.FixedZoomPolicy;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

/** Tests the percepts of a camera at the origin that looks along +y, with a 60 degree picture. */
class PicturePerceptTest {
  private static final String CAMERA =
      "<optics name='o' hfov='60' reach='10' pan='0 60' pan_speed='40'/>"
          + "<camera name='a' x='0' y='0' heading='0' viewing_angle='60' range='10' optics='o'/>";

  @Test
  void emptyPictureHasNoParts() {
    assertPicture(0, false, "");
    assertPicture(0, true, "");
  }

  @Test
  void distinguishesThirdsOfTheAngle() {
    assertPicture(0b001, false, at(-29, 3));
    assertPicture(0b001, false, at(-11, 3));
    assertPicture(0b010, false, at(-9, 3));
    assertPicture(0b010, false, at(9, 3));
    assertPicture(0b100, false, at(11, 3));
    assertPicture(0b100, false, at(29, 3));
    assertPicture(0b101, false, at(-20, 3) + at(20, 9) + at(21, 9));
  }

  @Test
  void distinguishesNearAndFarAtHalfTheReach() {
    assertPicture(0b000_001, true, at(-20, 4.9));
    assertPicture(0b001_000, true, at(-20, 5.1));
    assertPicture(0b110_010, true, at(1, 3) + at(-1, 9) + at(20, 9));
  }

  /** The model detects up to 5 m, half the reach of the lens. */
  @Test
  void farDependsOnTheReachOfTheModel() {
    DetectionModel weak = new OnlyNear(5);
    ZoomPolicy still = new FixedZoomPolicy(Options.none("fixed"));
    Simulation run = RealWorld.run(CAMERA + at(-20, 2.4) + at(20, 2.6), weak, still, 1);
    run.step();
    assertEquals(0b100_001, look(run.network(), true));
  }

  private record OnlyNear(double metres) implements DetectionModel {
    @Override
    public String name() {
      return "only-near";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance <= metres ? 1 : 0;
    }
  }

  @Test
  void ignoresTargetsOutOfViewOrHidden() {
    String wall = "<wall x1='-1' y1='2' x2='1' y2='2'/>";
    assertPicture(0b001, false, at(31, 3) + at(0, 10.1) + at(-20, 3));
    assertPicture(0b100, false, wall + at(0, 3) + at(28, 6));
  }

  @Test
  void isEmptyWhileTheCameraMovesBlindly() {
    Simulation run = run("fixed:0,pans=1", at(20, 3) + at(60, 3));
    assertEquals(-1, run.network().seeing(0));
    assertEquals(0, look(run.network(), false));
    run.step();
    assertEquals(0b010, look(run.network(), false), "there now");
  }

  private static void assertPicture(int parts, boolean depth, String targets) {
    PicturePercept picture = new PicturePercept(1, depth);
    picture.update(run("fixed", at(0, -5)).network());
    NetworkView network = run("fixed", targets).network();
    assertEquals(parts, picture.presentPercept(network, 0));
    picture.update(network);
    assertEquals(parts, picture.lastPercept(0));
  }

  private static int look(NetworkView network, boolean depth) {
    PicturePercept picture = new PicturePercept(1, depth);
    picture.update(network);
    return picture.lastPercept(0);
  }

  private static Simulation run(String policy, String targets) {
    int colon = policy.indexOf(':');
    Options options =
        colon < 0 ? Options.none(policy) : Options.parse("fixed", policy.substring(colon + 1));
    Simulation run = RealWorld.run(CAMERA + targets, new FixedZoomPolicy(options), 1);
    run.step();
    return run;
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
}
