package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import net.jqwik.api.Assume;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class VisibilityTest {
  private static final double BORDER = 1e-7;
  private static final Pose ORIGIN = Pose.of(0, 0, 0);
  private static final Visibility STANDARD = Visibility.of(Detection.of(new GeometricDetection()));
  private static final Visibility CAMSIM =
      Visibility.asInCamSim(Detection.of(new GeometricDetection()), 0);

  /** A model whose value is the distance minus 1. */
  private record Far(boolean dependsOnBearing) implements DetectionModel {
    @Override
    public String name() {
      return "far";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance - 1;
    }
  }

  /** A model whose value falls from 1 at the camera to 0 at 4 m. */
  private record Near(boolean dependsOnBearing) implements DetectionModel {
    @Override
    public String name() {
      return "near";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return 1 - distance / 4;
    }

    @Override
    public Optional<Scatter> scatter() {
      return Optional.of(new Scatter(0, 0.1));
    }
  }

  /** A model whose value is the angle off the axis. */
  private record Bearing() implements DetectionModel {
    @Override
    public String name() {
      return "bearing";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return offAxis;
    }

    @Override
    public boolean dependsOnBearing() {
      return true;
    }
  }

  @Test
  void allRoundCamSimCameraMissesTargetsExactlyBehindIt() {
    Visibility visibility = Visibility.asInCamSim(Detection.of(new CamSimVisibilityDetection()), 0);
    ZoomLevel allRound = new ZoomLevel(4, 4, 4, Double.NaN, 2 * Math.PI);
    assertEquals(0, confidence(visibility, ORIGIN, allRound, 0, -3, 1, 0));
    assertEquals(0, confidence(visibility, ORIGIN, allRound, 0, 0, 1, 0));
    assertEquals(1 / 3.25, confidence(visibility, ORIGIN, allRound, 1e-7, -3, 1, 0), 1e-9);
    assertEquals(1 / 3.25, confidence(visibility, ORIGIN, allRound, 3, 0, 1, 0));
  }

  @Property
  void allRoundCamSimConfidenceUsesTrueAngle(
      @ForAll @DoubleRange(min = -10, max = 10) double x,
      @ForAll @DoubleRange(min = -10, max = 10) double y,
      @ForAll @DoubleRange(min = -720, max = 720) double heading) {
    CamSimVisibilityDetection model = new CamSimVisibilityDetection();
    Visibility visibility = Visibility.asInCamSim(Detection.of(model), 0);
    Pose camera = Pose.of(1, 2, Math.toRadians(heading));
    ZoomLevel zoom = zoom(360, 30);
    double expected = model.confidence(1, camera.distance(x, y), camera.offAxis(x, y), zoom);
    assertEquals(expected, confidence(visibility, camera, zoom, x, y, 1, 0));
  }

  /** Compares the scalar product with a computation by bearings. */
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
    Pose camera = Pose.of(cameraX, cameraY, Math.toRadians(heading));
    ZoomLevel zoom = zoom(angle, range);
    boolean within = off < angle / 2;
    for (Visibility visibility : new Visibility[] {STANDARD, CAMSIM}) {
      assertEquals(within, isInAngle(visibility, camera, zoom, x, y));
      assertEquals(within && distance < range, sees(visibility, camera, zoom, x, y));
    }
    assertEquals(distance, camera.distance(x, y), 1e-12 * distance);
    if (off > 1e-3 && off < 179.9) {
      assertEquals(Math.toRadians(off), camera.offAxis(x, y), 1e-9);
    }
  }

  @Property
  void allRoundSeesEveryBearing(
      @ForAll @DoubleRange(min = -180, max = 180) double bearing,
      @ForAll @DoubleRange(min = -720, max = 720) double heading) {
    double x = 3 * Math.sin(Math.toRadians(bearing));
    double y = 3 * Math.cos(Math.toRadians(bearing));
    Pose camera = Pose.of(0, 0, Math.toRadians(heading));
    assertTrue(sees(STANDARD, camera, zoom(360, 5), x, y));
    assertTrue(sees(CAMSIM, camera, zoom(360, 5), x, y));
  }

  @Test
  void includesTheRadius() {
    for (Visibility visibility : new Visibility[] {STANDARD, CAMSIM}) {
      assertTrue(sees(visibility, ORIGIN, zoom(360, 5), 3, 4));
      assertTrue(sees(visibility, ORIGIN, zoom(360, 5), 0, 5));
      assertFalse(sees(visibility, ORIGIN, zoom(360, 5), 0, Math.nextUp(5.0)));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 90, 180, 270, 359.9})
  void seesTargetAtCameraUnlikeCamSim(double angle) {
    Pose camera = Pose.of(2, 3, Math.toRadians(45));
    assertTrue(sees(STANDARD, camera, zoom(angle, 5), 2, 3));
    assertFalse(sees(CAMSIM, camera, zoom(angle, 5), 2, 3));
    assertTrue(Double.isNaN(camera.offAxis(2, 3)));
    assertEquals(0, camera.squaredDistance(2, 3));
  }

  @Test
  void allRoundSeesTargetAtCamera() {
    assertTrue(sees(STANDARD, ORIGIN, zoom(360, 5), 0, 0));
    assertTrue(sees(CAMSIM, ORIGIN, zoom(360, 5), 0, 0));
  }

  @Test
  void includesSectorBorderUnlikeCamSim() {
    assertTrue(sees(STANDARD, ORIGIN, zoom(270, 5), 1, -1));
    assertFalse(sees(CAMSIM, ORIGIN, zoom(270, 5), 1, -1));
  }

  @Test
  void reachOfZeroIncludesOnlyTheCamera() {
    assertTrue(sees(STANDARD, ORIGIN, zoom(360, 0), 0, 0));
    assertFalse(sees(STANDARD, ORIGIN, zoom(360, 0), 0, 1e-9));
  }

  @Test
  void wideAnglesExcludeWedgeBehind() {
    ZoomLevel zoom = zoom(300, 5);
    for (Visibility visibility : new Visibility[] {STANDARD, CAMSIM}) {
      assertTrue(sees(visibility, ORIGIN, zoom, 0, 1));
      assertTrue(sees(visibility, ORIGIN, zoom, 1, 0));
      assertTrue(sees(visibility, ORIGIN, zoom, 1, -1));
      assertFalse(sees(visibility, ORIGIN, zoom, 0.5, -1));
      assertFalse(sees(visibility, ORIGIN, zoom, 0, -1));
    }
  }

  @Test
  void neverSeesTargetAtNaN() {
    assertFalse(sees(STANDARD, ORIGIN, zoom(360, 5), Double.NaN, 0));
    assertFalse(sees(CAMSIM, ORIGIN, zoom(360, 5), 0, Double.NaN));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void confidenceIsZeroBelowThreshold(boolean byBearing) {
    Visibility visibility = Visibility.of(new Detection(new Far(byBearing), 0.5));
    assertEquals(0, confidence(visibility, ORIGIN, zoom(360, 5), 0, 1.25, 1, 0));
    assertEquals(0.25, value(visibility, ORIGIN, zoom(360, 5), 0, 1.25, 1));
    assertEquals(0.5, confidence(visibility, ORIGIN, zoom(360, 5), 0, 1.5, 1, 0));
    assertEquals(1, confidence(visibility, ORIGIN, zoom(360, 5), 0, 3, 1, 0));
    assertEquals(2, value(visibility, ORIGIN, zoom(360, 5), 0, 3, 1));
  }

  @Test
  void camSimNeverDetectsZeroConfidence() {
    Detection detection = new Detection(new Far(false), 0);
    assertEquals(0, Visibility.of(detection).detection().threshold());
    assertEquals(Double.MIN_VALUE, Visibility.asInCamSim(detection, 0).detection().threshold());
  }

  @Test
  void camSimVisibilityMayExceedOne() {
    Visibility visibility = Visibility.asInCamSim(Detection.of(new CamSimVisibilityDetection()), 0);
    double close = 1 / (0.25 + (0.5 - 0.25) / 0.5);
    assertEquals(close, confidence(visibility, ORIGIN, zoom(360, 0.5), 0, 0.25, 1, 0));
    assertTrue(close > 1);
  }

  @Test
  void includesShorterReachUnlessModelDependsOnBearing() {
    assertTrue(includes(STANDARD, zoom(90, 5), zoom(90, 4)));
    assertFalse(includes(STANDARD, zoom(90, 4), zoom(90, 5)));
    assertFalse(includes(STANDARD, zoom(80, 5), zoom(90, 4)));
    Visibility byBearing = Visibility.of(Detection.of(new Far(true)));
    assertTrue(includes(byBearing, zoom(90, 5), zoom(90, 5)));
    assertFalse(includes(byBearing, zoom(90, 5), zoom(90, 4)));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void obstaclesReduceValueUnderThreshold(boolean byBearing) {
    Visibility visibility = Visibility.of(new Detection(new Near(byBearing), 0.5));
    ZoomLevel zoom = zoom(90, 5);
    assertEquals(0.6, confidence(visibility, ORIGIN, zoom, 0, 1, 1, 0, 0.8), 1e-15);
    assertEquals(0, confidence(visibility, ORIGIN, zoom, 0, 1, 1, 0, 0.6), "0.45");
    assertEquals(1, chance(visibility, ORIGIN, zoom, 0, 1, 1, 0.8));
    assertEquals(0, chance(visibility, ORIGIN, zoom, 0, 1, 1, 0.6));
    assertEquals(1, chance(visibility, ORIGIN, zoom, 0, 1, 1));
    assertEquals(0, chance(visibility, ORIGIN, zoom, 1, 0, 1), "beside the sector");
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void obstaclesReduceChanceButNotValue(boolean byBearing) {
    Detection detection =
        Detection.by(DetectionRule.parse("probability"), "near", new Near(byBearing));
    Visibility visibility = Visibility.of(detection, 7);
    ZoomLevel zoom = zoom(90, 3);
    assertEquals(0.75, chance(visibility, ORIGIN, zoom, 0, 1, 1));
    assertEquals(0.375, chance(visibility, ORIGIN, zoom, 0, 1, 1, 0.5));
    assertEquals(0.25, chance(visibility, ORIGIN, zoom, 0, 3, 1), "on the border");
    assertEquals(0, chance(visibility, ORIGIN, zoom, 0, 3.1, 1), "out of reach");
    assertEquals(0, chance(visibility, ORIGIN, zoom, 1, 0, 1), "beside the sector");
    assertEquals(0.75, confidence(visibility, ORIGIN, zoom, 0, 1, 1, 0.3, 0.5));
    assertEquals(0, confidence(visibility, ORIGIN, zoom, 0, 1, 1, 0.4, 0.5));
  }

  @Test
  void reachEndsAtLastDistanceAboveThreshold() {
    Visibility near = Visibility.of(new Detection(new Near(false), 0.5));
    assertEquals(2, near.at(zoom(360, 5), 1).reach(), 1e-6);
    assertTrue(near.at(zoom(360, 5), 1).reach() > 2, "rounded up");
    assertEquals(1, near.at(zoom(360, 1), 1).reach(), 1e-6);
    assertEquals(0, Visibility.of(new Detection(new Near(false), 2)).at(zoom(360, 5), 1).reach());
    Visibility byBearing = Visibility.of(new Detection(new Near(true), 0.5));
    assertEquals(5, byBearing.at(zoom(360, 5), 1).reach(), 1e-6);
    assertTrue(Visibility.roundedUp(0) > 0);
    assertTrue(Visibility.roundedUp(1e-100) > 1e-100);
  }

  /** Points on a lattice are often on a border. */
  @Test
  void camSimAngleAgreesWithArcCosine() {
    Random random = new Random(5);
    int inside = 0;
    for (int i = 0; i < 100_000; i++) {
      Pose camera = Pose.of(random.nextInt(5), random.nextInt(5), random.nextInt(8) * Math.PI / 4);
      ZoomLevel zoom = zoom(random.nextInt(1, 8) * 45, 20);
      boolean lattice = random.nextBoolean();
      double x = lattice ? random.nextInt(-4, 9) : random.nextDouble() * 13 - 4;
      double y = lattice ? random.nextInt(-4, 9) : random.nextDouble() * 13 - 4;
      boolean isInside = camera.offAxis(x, y) < zoom.viewingAngle() / 2;
      assertEquals(isInside, isInAngle(CAMSIM, camera, zoom, x, y));
      inside += isInside ? 1 : 0;
    }
    assertTrue(inside > 30_000 && inside < 70_000, inside + " inside");
  }

  @Test
  void angleCheckEqualsSector() {
    ZoomLevel zoom = zoom(90, 5);
    for (Visibility visibility : new Visibility[] {STANDARD, CAMSIM}) {
      assertTrue(isInAngle(visibility, ORIGIN, zoom, 0.9, 1));
      assertFalse(isInAngle(visibility, ORIGIN, zoom, 1.1, 1));
    }
    assertTrue(isInAngle(STANDARD, ORIGIN, zoom, 0, 0), "the camera's own position");
    assertFalse(isInAngle(CAMSIM, ORIGIN, zoom, 0, 0));
  }

  @Test
  void passesBearingToModel() {
    Visibility visibility = Visibility.of(new Detection(new Bearing(), 0.1));
    assertEquals(Math.PI / 4, value(visibility, ORIGIN, zoom(360, 5), 1, 1, 1), 1e-12);
    assertEquals(0, value(visibility, ORIGIN, zoom(360, 5), 0, 0, 1), "no bearing at all");
  }

  @Test
  void phantomsComeAtRateOfFalseAlarms() {
    String text = "chance:alpha=0.3";
    assertEquals(0, phantoms(text));
    assertEquals(3000, phantoms(text + ",phantoms=on"), 200);
  }

  /** Counts phantoms in 100 steps of 100 cameras. */
  private static int phantoms(String rule) {
    Detection detection = Detection.by(DetectionRule.parse(rule), "near", new Near(false));
    Visibility visibility = Visibility.of(detection, 3);
    int phantoms = 0;
    for (int i = 0; i < 10_000; i++) {
      phantoms += visibility.phantoms(i / 100, i % 100);
    }
    return phantoms;
  }

  private static double confidence(
      Visibility visibility,
      Pose camera,
      ZoomLevel zoom,
      double x,
      double y,
      double size,
      double luck) {
    return confidence(visibility, camera, zoom, x, y, size, luck, 1);
  }

  private static double confidence(
      Visibility visibility,
      Pose camera,
      ZoomLevel zoom,
      double x,
      double y,
      double size,
      double luck,
      double transmittance) {
    return visibility.at(zoom, size).confidence(camera, x, y, luck, transmittance);
  }

  private static double chance(
      Visibility visibility, Pose camera, ZoomLevel zoom, double x, double y, double size) {
    return chance(visibility, camera, zoom, x, y, size, 1);
  }

  private static double chance(
      Visibility visibility,
      Pose camera,
      ZoomLevel zoom,
      double x,
      double y,
      double size,
      double transmittance) {
    return visibility.at(zoom, size).chance(camera, x, y, transmittance);
  }

  private static double value(
      Visibility visibility, Pose camera, ZoomLevel zoom, double x, double y, double size) {
    return visibility.at(zoom, size).value(camera, x, y);
  }

  private static boolean isInAngle(
      Visibility visibility, Pose camera, ZoomLevel zoom, double x, double y) {
    return visibility.at(zoom, 1).isInAngle(camera, x, y);
  }

  /** Whether one level includes another for targets of 1 m. */
  private static boolean includes(Visibility visibility, ZoomLevel zoom, ZoomLevel other) {
    return visibility.at(zoom, 1).includes(visibility.at(other, 1));
  }

  private static boolean sees(
      Visibility visibility, Pose camera, ZoomLevel zoom, double x, double y) {
    return confidence(visibility, camera, zoom, x, y, 0.66, 0) > 0;
  }

  /**
   * @param angle the angle, in degrees
   */
  private static ZoomLevel zoom(double angle, double radius) {
    return new ZoomLevel(radius, radius, radius, Double.NaN, Math.toRadians(angle));
  }
}
