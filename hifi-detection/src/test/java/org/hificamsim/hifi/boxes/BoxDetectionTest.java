package org.hificamsim.hifi.boxes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.model.BoxDetections;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.Test;

class BoxDetectionTest {
  private static final BoxDetection MODEL =
      new BoxDetection(
          "mine",
          new FoundCurve(1, 2, 5, 0.1, 0.9),
          new Optics(0.0224, 0.085),
          0.7,
          Optional.empty(),
          Provenance.UNKNOWN);

  private static final double RIGHT_ANGLE = Math.PI / 2;
  private static final ZoomLevel LENS =
      new ZoomLevel(50, 50, 50, Double.NaN, RIGHT_ANGLE, RIGHT_ANGLE, 1000);

  @Test
  void countsPixelsOfHeight() {
    assertEquals(100, MODEL.pixels(2, 10, LENS), 1e-9, "1000 pixels on 20 m, 2 m high");
    double atHundred = 0.1 + 0.8 / (1 + Math.exp(-1));
    assertEquals(atHundred, MODEL.confidence(2, 10, 0, LENS), 1e-12);
    assertEquals(0.1 + 0.8 / (1 + Math.exp(1.5)), MODEL.confidence(2, 10, 0, LENS, 0.5), 1e-12);
    assertEquals(0.9, MODEL.confidence(2, 0, 0, LENS), 1e-12, "the ceiling at distance 0");
  }

  @Test
  void seesHeightsThroughTiltedLensAsAPinholeCamera() {
    VerticalView view = new VerticalView(10, Math.toRadians(30), Math.toRadians(60));
    Detection onMast = Detection.of(MODEL).inSpace(10 - 1, false);
    double distance = 17.3;
    double feet = Math.tan(Math.atan2(10, distance) - Math.toRadians(30));
    double head = Math.tan(Math.atan2(8, distance) - Math.toRadians(30));
    double expected = MODEL.curve().found(500 * (feet - head), 0);
    assertEquals(expected, onMast.model().confidence(2, distance, 0, LENS.with(view)), 1e-9);
    double turned = 500 * 2 * distance / (distance * distance + 81);
    VerticalView unlimited = new VerticalView(10, 0, Double.NaN);
    assertEquals(
        MODEL.curve().found(turned, 0),
        onMast.model().confidence(2, distance, 0, LENS.with(unlimited)),
        1e-3);
  }

  @Test
  void decidesByProbabilityByDefault() {
    assertEquals("probability", MODEL.defaultRule().text());
    Detection byChance = Detection.by(DetectionRule.parse("chance"), "mine", MODEL);
    assertEquals(0.37, byChance.chance(0.37));
    assertThrows(
        InputException.class,
        () -> Detection.by(DetectionRule.parse("chance:alpha=0.01"), "mine", MODEL));
  }

  @Test
  void drawsPhantomsFromFalseAlarms() {
    Detection with = Detection.by(DetectionRule.parse("probability:phantoms=on"), "m", MODEL);
    Detection without = Detection.by(DetectionRule.parse("probability"), "m", MODEL);
    double sum = 0;
    for (int i = 0; i < 10_000; i++) {
      sum += with.phantoms((i + 0.5) / 10_000);
      assertEquals(0, without.phantoms((i + 0.5) / 10_000));
    }
    assertEquals(0.7, sum / 10_000, 1e-3);
  }

  @Test
  void shippedModelIsReadAndMonotone() {
    Registry<DetectionModel> registry = new Registry<>("detection");
    BoxDetections.register(registry);
    BoxDetection shipped = (BoxDetection) registry.create("boxes:frcnn-2016");
    assertEquals("boxes:frcnn-2016", shipped.name());
    assertTrue(shipped.curve().found(200, 0) > 0.9);
    assertTrue(shipped.curve().found(60, 0) > shipped.curve().found(60, 0.5));
  }

  private static void assertRejected(String expected, String found) {
    String json =
        "{\"schema\": \"hificamsim-model\", \"version\": 4, \"name\": \"m\", \"found\": "
            + found
            + "}";
    byte[] bytes = json.getBytes(StandardCharsets.UTF_8);
    InputException refused =
        assertThrows(InputException.class, () -> ModelFiles.parse("m.json", bytes));
    assertTrue(refused.getMessage().contains(expected), refused.getMessage());
    assertTrue(refused.getMessage().startsWith("m.json:1:"), refused.getMessage());
  }

  @Test
  void targetsOfScenariosHaveTheUsualShape() {
    FoundCurve curve = new FoundCurve(1, 3, 5, 0, 1, new WidthEffect(2, 0.4));
    assertEquals(curve.found(80, 0.2), curve.found(80, 0.4 * 80, 0.2), 1e-12);
    double wider = Math.log(curve.found(80, 40, 0) / (1 - curve.found(80, 40, 0)));
    double usual = Math.log(curve.found(80, 0) / (1 - curve.found(80, 0)));
    assertEquals(2 * Math.log(40 / 32.0), wider - usual, 1e-9);
    assertTrue(curve.equation().contains("+ 2.00 ln(w / (0.400 px))"), curve.equation());
  }

  @Test
  void errorsNameInvalidNumbersInFiles() {
    assertRejected("height", "{\"intercept\": 1, \"height\": -2, \"hidden\": 1}");
    assertRejected("hidden", "{\"intercept\": 1, \"height\": 2}");
    assertRejected(
        "ceiling above the floor",
        "{\"intercept\": 1, \"height\": 2, \"hidden\": 1, \"floor\": 0.5, \"ceiling\": 0.2}");
    assertRejected("floor", "{\"intercept\": 1, \"height\": 2, \"hidden\": 1, \"floor\": 1}");
    assertRejected("unknown", "{\"intercept\": 1, \"height\": 2, \"hidden\": 1, \"slope\": 1}");
    String start = "{\"intercept\": 1, \"height\": 2, \"hidden\": 1, \"width\": ";
    assertRejected("slope", start + "{\"slope\": 2.5, \"usualShape\": 0.3}}");
    assertRejected("usualShape", start + "{\"slope\": 1, \"usualShape\": 0}}");
  }
}
