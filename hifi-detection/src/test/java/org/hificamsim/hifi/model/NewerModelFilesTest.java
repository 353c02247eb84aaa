package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.DetectionModelContract;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.IsotonicCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;
import org.hificamsim.hifi.feature.PinholeAbstraction;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests model files of version 2: every shape of g, and the data that a model was fitted on. */
class NewerModelFilesTest {
  private static final FittedOn ON =
      new FittedOn(new Span(0.1, 0.66), new Span(1, 10), new Span(0.01, 0.085), 8, 0.02, 1.0 / 3);

  private static final String MODEL =
      """
      {
        "schema": "hificamsim-model",
        "version": 2,
        "name": "mine",
        "f": {"type": "pinhole", "sensorWidth": 0.02, "sensorHeight": 0.01},
        "g": {"type": "hill", "floor": 0.01, "rise": 0.6, "half": 0.04, "exponent": 1.5},
        "fitted": {
          "q": {"least": 0.1, "most": 0.66},
          "d": {"least": 1, "most": 10},
          "z": {"least": 0.01, "most": 0.085},
          "objects": 8, "betweenObjects": 0.02, "withinObjects": 0.05}
      }
      """;

  static Stream<DetectorModel> shapes() {
    return Stream.of(
        new DetectorLine(0.6, 0.02),
        new SaturatingExponential(0.02, 0.6, 1.0 / 3),
        new HillCurve(-0.02, 0.6, 0.04, Math.PI),
        new LogisticCurve(0.04, 0.7),
        new IsotonicCurve(new double[][] {{0.001, 0.05}, {0.02, 0.2}, {0.1, 0.7}, {0.2, 0.7}}));
  }

  @TestFactory
  Stream<DynamicContainer> everyShapeKeepsTheContract() {
    return shapes()
        .map(g -> DetectionModelContract.of("shape", () -> model("shape", g, Optional.of(ON))));
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void everyShapeSurvivesWritingAndReading(DetectorModel g) {
    HiFiDetection model = model("mine", g, Optional.of(ON));
    byte[] bytes = ModelFiles.bytes(model);
    assertEquals(model, ModelFiles.parse("mine", bytes));
    assertTrue(text(model).contains("\"version\": 2"), text(model));
  }

  @Test
  void writesOldestVersionThatHoldsTheModel() {
    String old = text(model("mine", new DetectorLine(0.6, 0.02), Optional.empty()));
    assertTrue(old.contains("\"version\": 1"), old);
    assertFalse(old.contains("\"type\": \"line\""), old);
    assertFalse(old.contains("fitted"), old);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void detectionFallsWithDistanceByThresholdAndChance(DetectorModel g) {
    HiFiDetection model = model("mine", g, Optional.empty());
    ZoomLevel zoom = new ZoomLevel(20, 10, 30, Double.NaN, 2 * Math.PI);
    double limit = 0.66 * model.optics().focalLength(zoom) / Math.sqrt(0.02 * 0.0224 * 0.015);
    Detection detection = new Detection(model, g.confidence(0.02));
    assertTrue(detection.distances(0.66, zoom).contains(limit * limit * (1 - 1e-9)), g.toString());
    assertFalse(detection.distances(0.66, zoom).contains(limit * limit * (1 + 1e-9)), g.toString());
    Detection chance = Detection.by(DetectionRule.parse("chance:alpha=0.05"), "mine", model);
    double near = chance.chance(model.confidence(0.66, 1, 0, zoom));
    double far = chance.chance(model.confidence(0.66, 1e9, 0, zoom));
    assertEquals(0, far, 1e-9, g + ": no detections at a confidence of 0");
    assertTrue(near > 0.9, g + ": " + near);
  }

  @Test
  void growingScatterSurvivesInVersion3() {
    HiFiDetection withoutGrowth = model("mine", new DetectorLine(0.6, 0.02), Optional.empty());
    HiFiDetection growing =
        new HiFiDetection(
            "mine",
            withoutGrowth.f(),
            withoutGrowth.g(),
            withoutGrowth.optics(),
            0.05,
            Optional.of(new Residuals(0.05, 0.01, 1.0 / 3)),
            Optional.empty(),
            Provenance.UNKNOWN);
    String text = text(growing);
    assertTrue(text.contains("\"version\": 3") && text.contains("\"rmse\": 0.05"), text);
    assertEquals(growing, ModelFiles.parse("mine", text.getBytes(StandardCharsets.UTF_8)));
    assertEquals(
        Optional.of(new Scatter(0.02, 0.05, 0.01, 1.0 / 3)), growing.scatter(), "all four numbers");
    String older = text.replace("\"version\": 3", "\"version\": 2");
    InputException fault =
        assertThrows(
            InputException.class,
            () -> ModelFiles.parse("m.json", older.getBytes(StandardCharsets.UTF_8)));
    assertTrue(fault.getMessage().contains("scatter"), fault.getMessage());
  }

  @Test
  void defaultThresholdIsTheConfidenceAtTheReferencePip() {
    HiFiDetection model =
        (HiFiDetection) ModelFiles.parse("m", MODEL.getBytes(StandardCharsets.UTF_8));
    assertEquals(model.g().confidence((0.0441 - 0.026) / 0.571), model.defaultThreshold(), 1e-12);
    assertEquals(0.05, model.fitted().orElseThrow().withinObjects());
  }

  @Test
  void spanContainsItsEndsDespiteRounding() {
    Span span = Span.of(new double[] {0.3, 0.1});
    assertEquals(new Span(0.1, 0.3), span);
    assertTrue(span.contains(0.1 + 0.2) && span.contains(0.1));
    assertFalse(span.contains(0.31) || span.contains(0.09));
  }

  @Test
  void spanMayHaveOneLength() {
    String withoutGrowth = MODEL.replace("\"most\": 0.085", "\"most\": 0.01");
    HiFiDetection model =
        (HiFiDetection) ModelFiles.parse("m", withoutGrowth.getBytes(StandardCharsets.UTF_8));
    assertEquals(new Span(0.01, 0.01), model.fitted().orElseThrow().focalLength());
  }

  @Test
  void writesEachPropertyAndRowOnItsOwnLine() {
    DetectorModel knots = new IsotonicCurve(new double[][] {{0.001, 0.05}, {0.02, 0.2}});
    assertEquals(
        """
        {
          "schema": "hificamsim-model",
          "version": 2,
          "name": "mine",
          "f": {
            "type": "pinhole",
            "sensorWidth": 0.0224,
            "sensorHeight": 0.015
          },
          "g": {
            "type": "isotonic",
            "knots": [
              [0.001,0.05],
              [0.02,0.2]
            ],
            "rmse": 0.05
          },
          "optics": {
            "sensorWidth": 0.0224,
            "longestFocalLength": 0.085
          },
          "threshold": 0.2,
          "units": {
            "q": "m",
            "d": "m",
            "z": "m"
          },
          "provenance": { }
        }
        """,
        text(model("mine", knots, Optional.empty())));
  }

  static Stream<Arguments> faults() {
    return Stream.of(
        arguments(
            "\"version\": 2", "\"version\": 5", "3:14: version is 5, expected 1 or 2 or 3 or 4"),
        arguments("\"version\": 2", "\"version\": 1", "'slope' is missing"),
        arguments("\"hill\"", "\"cubic\"", "6:17: type is 'cubic', expected one of line, satur"),
        arguments("\"half\": 0.04", "\"half\": 0", "half is 0, expected a number from 1.0E-12"),
        arguments("\"rise\": 0.6", "\"rise\": -0.6", "rise is -0.6"),
        arguments("\"exponent\": 1.5", "\"exponent\": NaN", "exponent is NaN"),
        arguments("\"most\": 0.66", "\"most\": 0.06", "most is 0.06, expected 0.1 or more"),
        arguments("\"objects\": 8", "\"objects\": 2.5", "objects is 2.5, expected a whole number"),
        arguments("\"objects\": 8", "\"objects\": 0", "objects is 0"),
        arguments(", \"most\": 10", "", "9:10: property 'most' is missing"),
        arguments("\"least\": 0.01", "\"least\": -1", "least is -1, expected a number from 0"),
        arguments("\"objects\": 8", "\"objects\": \"8\"", "objects is '8', expected a number"),
        arguments(
            "\"version\": 2",
            "\"version\": 2, \"covariates\": {\"light\": {\"weight\": 2}}",
            "3:31: covariates is an object, expected none: such models are no longer supported"),
        arguments(
            "\"version\": 2", "\"version\": 2, \"fited\": 1", "3:17: unknown property 'fited'"),
        arguments("\"d\": {", "\"y\": {", "'d' is missing"),
        arguments(
            "\"hill\", \"floor\": 0.01, \"rise\": 0.6, \"half\": 0.04, \"exponent\": 1.5",
            "\"isotonic\", \"knots\": [[0.1, 0.2], [0.2, 0.1]]",
            "confidence not to fall at knot 2"));
  }

  @ParameterizedTest
  @MethodSource("faults")
  void reportsErrorsWithPlaceAndValue(String right, String wrong, String message) {
    byte[] bytes = MODEL.replace(right, wrong).getBytes(StandardCharsets.UTF_8);
    InputException error =
        assertThrows(InputException.class, () -> ModelFiles.parse("m.json", bytes));
    assertTrue(error.getMessage().contains(message), error.getMessage());
    assertTrue(error.getMessage().startsWith("m.json:"), error.getMessage());
  }

  private static String text(HiFiDetection model) {
    return new String(ModelFiles.bytes(model), StandardCharsets.UTF_8);
  }

  private static HiFiDetection model(String name, DetectorModel g, Optional<FittedOn> on) {
    return new HiFiDetection(
        name,
        new PinholeAbstraction(0.0224, 0.015),
        g,
        new Optics(0.0224, 0.085),
        g.confidence(0.02),
        Optional.of(Residuals.of(0.05)),
        on,
        Provenance.UNKNOWN);
  }
}
