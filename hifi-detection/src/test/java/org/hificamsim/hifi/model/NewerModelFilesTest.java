package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Condition;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.CovariateTerm;
import org.hificamsim.hifi.DetectionModelContract;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
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

/** Model files of version 2: every shape of g, what a model was fitted on, and covariates. */
class NewerModelFilesTest {
  private static final FittedOn ON =
      new FittedOn(new Span(0.1, 0.66), new Span(1, 10), new Span(0.01, 0.085), 8, 0.02, 1.0 / 3);

  private static final ZoomLevel ZOOM = new ZoomLevel(20, 10, 20, Double.NaN, 2 * Math.PI);

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
          "objects": 8, "betweenObjects": 0.02, "withinObjects": 0.05},
        "covariates": {
          "aperture": {"weight": -0.1, "mean": 5, "least": 2.8, "most": 11},
          "light": {"weight": 2, "mean": 1, "least": 0.5, "most": 1.5}}
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
  void everyShapeSurvivesTheRoundTrip(DetectorModel g) {
    HiFiDetection model = model("mine", g, Optional.of(ON));
    byte[] bytes = ModelFiles.bytes(model);
    assertEquals(model, ModelFiles.parse("mine", bytes));
    assertTrue(text(model).contains("\"version\": 2"), text(model));
  }

  @Test
  void modelThatNeedsNothingNewIsWrittenAsBefore() {
    String old = text(model("mine", new DetectorLine(0.6, 0.02), Optional.empty()));
    assertTrue(old.contains("\"version\": 1"), old);
    assertFalse(old.contains("\"type\": \"line\""), old);
    assertFalse(old.contains("fitted"), old);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void detectsUpToOneDistanceByThresholdAndByChance(DetectorModel g) {
    HiFiDetection model = model("mine", g, Optional.empty());
    ZoomLevel zoom = new ZoomLevel(20, 10, 30, Double.NaN, 2 * Math.PI);
    double limit = 0.66 * model.optics().focalLength(zoom) / Math.sqrt(0.02 * 0.0224 * 0.015);
    Detection detection = new Detection(model, g.confidence(0.02));
    assertTrue(detection.distances(0.66, zoom).contains(limit * limit * (1 - 1e-9)), g.toString());
    assertFalse(detection.distances(0.66, zoom).contains(limit * limit * (1 + 1e-9)), g.toString());
    Detection chance = Detection.by(DetectionRule.parse("chance:alpha=0.05"), "mine", model);
    double near = chance.chance(model.confidence(0.66, 1, 0, zoom));
    double far = chance.chance(model.confidence(0.66, 1e9, 0, zoom));
    assertEquals(0.05, far, 1e-9, g.toString());
    assertTrue(near > 0.9, g + ": " + near);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void covariatesSurviveTheRoundTrip(DetectorModel g) {
    HiFiDetection model = lit(g);
    assertEquals(model, ModelFiles.parse("mine", ModelFiles.bytes(model)));
    assertTrue(text(model).contains("\"covariates\": {\n    \"aperture\": {"), text(model));
    assertFalse(text(model("mine", g, Optional.empty())).contains("covariates"));
  }

  @TestFactory
  Stream<DynamicContainer> everyShapeKeepsTheContractWithCovariates() {
    return shapes().map(g -> DetectionModelContract.of("mine", () -> lit(g)));
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void lightCountsAsALargerTarget(DetectorModel g) {
    HiFiDetection model = lit(g);
    HiFiDetection plain = model("mine", g, Optional.empty());
    assertEquals(plain.confidence(0.66, 5, 0, ZOOM), model.confidence(0.66, 5, 0, ZOOM));
    double bright = model.confidence(0.66, 5, 0, under(5, 1.25));
    assertEquals(plain.confidence(0.66 * Math.exp(0.25), 5, 0, ZOOM), bright, 1e-12);
    double open = model.confidence(0.66, 5, 0, under(2.8, 1));
    assertEquals(plain.confidence(0.66 * Math.exp(0.11), 5, 0, ZOOM), open, 1e-12);
  }

  @Test
  void beyondThePhotosTheNearestOfThemCounts() {
    HiFiDetection model = lit(new DetectorLine(0.6, 0.02));
    assertEquals(model.factor(new Conditions(5, 0, 1.5)), model.factor(new Conditions(5, 0, 1e9)));
    assertEquals(
        model.factor(new Conditions(11, 0, 0.5)), model.factor(new Conditions(1000, 0, 1e-300)));
    assertEquals(1, model.factor(Conditions.UNKNOWN));
  }

  @Test
  void lightMovesTheDistanceOfDetection() {
    HiFiDetection model = lit(new HillCurve(0.01, 0.6, 0.04, 1.5));
    Detection detection = new Detection(model, model.g().confidence(0.02));
    double limit = 0.66 * 0.085 * 0.5 / Math.sqrt(0.02 * 0.0224 * 0.015);
    for (double light : new double[] {0.5, 1, 1.5}) {
      double squared = limit * limit * Math.exp(2 * (light - 1));
      assertTrue(detection.distances(0.66, under(5, light)).contains(squared * (1 - 1e-9)));
      assertFalse(detection.distances(0.66, under(5, light)).contains(squared * (1 + 1e-9)));
    }
  }

  private static ZoomLevel under(double aperture, double light) {
    return ZOOM.under(new Conditions(aperture, Double.NaN, light));
  }

  private static HiFiDetection lit(DetectorModel g) {
    HiFiDetection plain = model("mine", g, Optional.of(ON));
    return new HiFiDetection(
        plain.name(),
        plain.f(),
        g,
        List.of(
            new CovariateTerm(Condition.LIGHT, 2, 1, new Span(0.5, 1.5)),
            new CovariateTerm(Condition.APERTURE, -0.1, 5, new Span(2.8, 11))),
        plain.optics(),
        plain.defaultThreshold(),
        plain.rmse(),
        plain.fitted(),
        plain.provenance());
  }

  @Test
  void defaultThresholdIsTheConfidenceAtTheReferencesShare() {
    HiFiDetection model = ModelFiles.parse("m", MODEL.getBytes(StandardCharsets.UTF_8));
    assertEquals((0.0441 - 0.026) / 0.571, model.g().pip(model.defaultThreshold()), 1e-12);
    assertEquals(0.05, model.fitted().orElseThrow().withinObjects());
  }

  @Test
  void spanHoldsItsEndsDespiteRounding() {
    Span span = Span.of(new double[] {0.3, 0.1});
    assertEquals(new Span(0.1, 0.3), span);
    assertTrue(span.contains(0.1 + 0.2) && span.contains(0.1));
    assertFalse(span.contains(0.31) || span.contains(0.09));
  }

  @Test
  void oneLengthAloneIsASpanToo() {
    String one = MODEL.replace("\"most\": 0.085", "\"most\": 0.01");
    HiFiDetection model = ModelFiles.parse("m", one.getBytes(StandardCharsets.UTF_8));
    assertEquals(new Span(0.01, 0.01), model.fitted().orElseThrow().focalLength());
  }

  @Test
  void isWrittenOnePropertyALineAndOneRowALine() {
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
        arguments("\"version\": 2", "\"version\": 3", "3:14: version is 3, expected 1 or 2"),
        arguments("\"version\": 2", "\"version\": 1", "'slope' is missing"),
        arguments("\"hill\"", "\"cubic\"", "6:17: type is 'cubic', expected one of line, satur"),
        arguments("\"half\": 0.04", "\"half\": 0", "half is 0, expected a number from 1.0E-12"),
        arguments("\"rise\": 0.6", "\"rise\": -0.6", "rise is -0.6"),
        arguments("\"exponent\": 1.5", "\"exponent\": NaN", "exponent is NaN"),
        arguments("\"most\": 0.66", "\"most\": 0.06", "most is 0.06, expected 0.1 or more"),
        arguments("\"objects\": 8", "\"objects\": 2.5", "objects is 2.5, expected a whole number"),
        arguments("\"objects\": 8", "\"objects\": 0", "objects is 0"),
        arguments(
            "\"light\"",
            "\"weather\"",
            "14:5: unknown property 'weather', expected one of aperture, distortion, light"),
        arguments(", \"most\": 11", "", "13:17: property 'most' is missing"),
        arguments("\"mean\": 5", "\"mean\": 12", "mean is 12, expected a number from 2.8 to 11"),
        arguments("\"least\": 0.5", "\"least\": 0", "least is 0, expected a number from 2.2"),
        arguments("\"weight\": 2", "\"weight\": 101", "weight is 101, expected at most 100.0"),
        arguments("\"weight\": 2", "\"weight\": \"2\"", "14:25: weight is '2', expected a number"),
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
  void faultsAreToldWithPlaceAndValue(String right, String wrong, String message) {
    byte[] bytes = MODEL.replace(right, wrong).getBytes(StandardCharsets.UTF_8);
    InputException told =
        assertThrows(InputException.class, () -> ModelFiles.parse("m.json", bytes));
    assertTrue(told.getMessage().contains(message), told.getMessage());
    assertTrue(told.getMessage().startsWith("m.json:"), told.getMessage());
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
        OptionalDouble.of(0.05),
        on,
        Provenance.UNKNOWN);
  }
}
