package org.hificamsim.runs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the precedence of options, scenario and default of the model. */
class DetectionSpecTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  @ParameterizedTest
  @CsvSource({
    "camsim-range@0.45, 0.2, 0.3, 0.45",
    "camsim-range, 0.2, 0.3, 0.2",
    "camsim-range, , 0.3, 0.3",
    "camsim-range, , , 0.35",
    "hifi:orb-lin@0, 0.2, , 0",
    "hifi:orb-lin@1, , 0.3, 1",
  })
  void usesFirstThresholdInOrderOfPrecedence(
      String detection, Double asked, Double scenarioValue, double expected) {
    assertEquals(expected, detection(detection, asked, scenarioValue).threshold());
  }

  @ParameterizedTest
  @CsvSource({
    "camsim-range, camsim-range",
    "camsim-range@0.45, camsim-range@0.45",
    "camsim-range@.450, camsim-range@0.45",
    "hifi:orb-lin@4e-2, hifi:orb-lin@0.04",
  })
  void nameContainsItsThreshold(String detection, String name) {
    assertEquals(name, detection(detection, 0.2, 0.3).name());
    assertEquals(
        detection.split("@", 2)[0], detection(detection, 0.2, 0.3).model().name(), "the model's");
  }

  @ParameterizedTest
  @CsvSource({
    "camsim-range@1.5, 'threshold is 1.5, expected a number from 0 to 1'",
    "camsim-range@-1, 'threshold is -1.0, expected a number from 0 to 1'",
    "camsim-range@e, 'threshold is ''e'', expected a number from 0 to 1'",
    "camsim-range@, unknown detection 'camsim-range@'",
    "a@b/model.json, a@b/model.json: no such file",
    "model@0.5.json, model@0.5.json: no such file",
    "model.json@0.5, model.json: no such file",
  })
  void rejectsMalformedDetections(String detection, String expected) {
    InputException fault =
        assertThrows(InputException.class, () -> detection(detection, null, null));
    assertTrue(fault.getMessage().startsWith(expected), fault.getMessage());
  }

  @Test
  void rejectsThresholdOutOfRange() {
    for (double threshold : new double[] {-0.1, 1.1, Double.NaN}) {
      assertThrows(InputException.class, () -> settings(threshold, null), "no fault");
    }
  }

  private static Detection detection(String text, Double asked, Double scenarioValue) {
    return DetectionSpec.parse(text, CATALOGUE::detection)
        .detection(
            settings(asked, null),
            scenarioValue == null ? OptionalDouble.empty() : OptionalDouble.of(scenarioValue),
            Optional.empty());
  }

  private static Settings settings(Double threshold, String rule) {
    Settings settings = Settings.NONE;
    if (threshold != null) {
      settings = settings.with(Setting.THRESHOLD, threshold.toString());
    }
    return rule == null ? settings : settings.with(Setting.DETECT, rule);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "hifi:orb-lin | | | threshold | hifi:orb-lin",
        "hifi:orb-lin | chance | | chance | hifi:orb-lin@chance",
        "hifi:orb-lin | chance:alpha=0.01,memory=2 | probability | chance:alpha=0.01,memory=2"
            + " | hifi:orb-lin@chance:alpha=0.01;memory=2",
        "hifi:orb-lin | | probability | probability | hifi:orb-lin@probability",
        "hifi:orb-lin@chance:alpha=0.01;memory=2 | threshold | probability"
            + " | chance:alpha=0.01,memory=2 | hifi:orb-lin@chance:alpha=0.01;memory=2",
        "hifi:orb-lin@threshold | chance | | threshold | hifi:orb-lin",
        "camsim-range@probability | | | probability | camsim-range@probability",
      })
  void usesFirstRuleInOrderOfPrecedence(
      String detection, String asked, String scenarioValue, String rule, String name) {
    Detection actual =
        DetectionSpec.parse(detection, CATALOGUE::detection)
            .detection(settings(null, asked), OptionalDouble.empty(), rule(scenarioValue));
    assertEquals(rule, actual.rule().text());
    assertEquals(name, actual.name());
  }

  @ParameterizedTest
  @CsvSource({
    "hifi:orb-lin@0.3, , chance, , 0.3",
    "hifi:orb-lin@0.3, , , chance, 0.3",
    "hifi:orb-lin, 0.4, , chance, 0.4",
    "hifi:orb-lin@0.3, 0.4, chance, , 0.3",
  })
  void thresholdOverridesRuleOfLowerPrecedence(
      String detection, Double asked, String rule, String scenarioValue, double expected) {
    Detection actual =
        DetectionSpec.parse(detection, CATALOGUE::detection)
            .detection(settings(asked, rule), OptionalDouble.empty(), rule(scenarioValue));
    assertTrue(actual.certain());
    assertEquals(expected, actual.threshold());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "hifi:orb-lin | 0.4 | threshold is 0.4, expected none with detect=chance",
        "camsim-range | | detection 'camsim-range' has no rmse",
        "hifi:orb-lin@chance:beta=1 | | detection rule chance: unknown option 'beta=1', expected"
            + " one of alpha",
      })
  void rejectsSettingsThatContradictTheRule(String detection, Double threshold, String expected) {
    InputException fault =
        assertThrows(
            InputException.class,
            () ->
                DetectionSpec.parse(detection, CATALOGUE::detection)
                    .detection(settings(threshold, "chance")));
    assertTrue(fault.getMessage().startsWith(expected), fault.getMessage());
  }

  private static Optional<DetectionRule> rule(String text) {
    return Optional.ofNullable(text).map(DetectionRule::parse);
  }
}
