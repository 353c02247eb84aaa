package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DetectionRuleTest {
  private static final ZoomLevel ZOOM = new ZoomLevel(8, 2, 8, Double.NaN, 2 * Math.PI);

  /** A model whose confidence falls from 1 to 0.2 over eight metres. */
  private record Falling(Optional<Scatter> scatter) implements DetectionModel {
    @Override
    public String name() {
      return "falling";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return 1 - distance / 10;
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "threshold",
        "chance",
        "chance:alpha=0.01",
        "chance:memory=25",
        "chance:alpha=0.1,memory=3,phantoms=on",
        "probability",
        "probability:memory=4"
      })
  void parsesItsOwnText(String text) {
    assertEquals(text, DetectionRule.parse(text).text());
  }

  @Test
  void textOmitsDefaults() {
    assertEquals("chance", DetectionRule.parse("chance:alpha=0.05,memory=1,phantoms=off").text());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "chances | unknown detection rule 'chances'",
        "chance:alpha=0 | chance: alpha is '0', expected a number from 1.0E-9 to 0.5",
        "chance:alpha=0.6 | chance: alpha is '0.6', expected",
        "chance:memory=0 | chance: memory is '0', expected a whole number from 1",
        "chance:phantoms=yes | chance: phantoms is 'yes', expected one of off, on",
        "probability:alpha=0.1 | unknown option 'alpha=0.1'",
        "threshold:0.4 | expected no options",
      })
  void rejectsInvalidRules(String text, String expected) {
    InputException fault =
        assertThrows(InputException.class, () -> DetectionRule.parse(text), "no fault");
    assertTrue(fault.getMessage().contains(expected), fault.getMessage());
  }

  @Test
  void chanceRejectsModelWithoutScatter() {
    DetectionModel model = new Falling(Optional.empty());
    InputException fault =
        assertThrows(
            InputException.class, () -> Detection.by(DetectionRule.parse("chance"), "x", model));
    assertTrue(fault.getMessage().contains("'falling' has no rmse"), fault.getMessage());
  }

  private static Detection byChance(String alpha, Scatter scatter) {
    return Detection.by(
        DetectionRule.parse("chance:alpha=" + alpha), "x", new Falling(Optional.of(scatter)));
  }

  /**
   * P = Phi((v - tau) / 0.1) with tau = 0.2 + 2.3263 * 0.1; without false alarms (P - 0.01) / 0.99.
   */
  @Test
  void chanceExcludesFalseAlarms() {
    Detection detection = byChance("0.01", new Scatter(0.2, 0.1));
    double tau = 0.2 + 2.3263478740408408 * 0.1;
    assertEquals(0, detection.chance(0.2), 1e-12);
    assertEquals(0, detection.chance(0.1));
    assertEquals((0.5 - 0.01) / 0.99, detection.chance(tau), 1e-12);
    assertEquals((0.8413447460685429 - 0.01) / 0.99, detection.chance(tau + 0.1), 1e-12);
    assertEquals(1, detection.chance(2), 1e-15);
    assertFalse(detection.detects(0.2, 0, 1), "nothing is detected where nothing is");
    assertFalse(detection.detects(Double.NaN, 0, 1));
  }

  @Test
  void detectsHalfOfTheTargetsAtItsThreshold() {
    for (double growth : new double[] {0, 0.3, 2}) {
      Detection detection = byChance("0.05", new Scatter(0.2, 0.1, 0.08, growth));
      assertEquals(0.5, detection.chance(detection.threshold()), 1e-12, "growth " + growth);
    }
    assertEquals(
        Double.POSITIVE_INFINITY,
        byChance("0.5", new Scatter(0.2, 0.1, 0.1, 2)).threshold(),
        "never");
  }

  /** The scatter at 0.7 is 0.02 + 0.4 * 0.5 = 0.22; without a target it is 0.02. */
  @Test
  void growingScatterGivesFewerFalseAlarms() {
    double tau = 0.2 + 1.6448536269514722 * 0.1;
    Scatter growing = new Scatter(0.2, 0.1, 0.02, 0.4);
    assertEquals(0.05, new Scatter(0.2, 0.1).falseAlarms(tau), 1e-12);
    double falseAlarms = NormalDistribution.cdf((0.2 - tau) / 0.02);
    assertEquals(falseAlarms, growing.falseAlarms(tau), 1e-15);
    assertTrue(falseAlarms < 1e-12);
    Detection detection = byChance("0.05", growing);
    assertEquals(0, detection.chance(0.2), 0);
    assertEquals(NormalDistribution.cdf((0.7 - tau) / 0.22), detection.chance(0.7), 1e-12);
  }

  @Test
  void probabilityIsTheClampedValue() {
    Detection detection =
        Detection.by(DetectionRule.parse("probability"), "x", new Falling(Optional.empty()));
    assertEquals(0.3, detection.chance(0.3));
    assertEquals(1, detection.chance(1.2));
    assertEquals(0, detection.chance(-0.2));
    assertTrue(detection.detects(0.3, 0.2999, 1));
    assertFalse(detection.detects(0.3, 0.3, 1));
  }

  /** Jumps at 3 m, where no cubic approximates it. */
  private record Jump(Optional<Scatter> scatter) implements DetectionModel {
    @Override
    public String name() {
      return "jump";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance < 3 ? 0.9 - distance / 100 : 0.2;
    }
  }

  @Test
  void chanceTableIsCloseToTheModel() {
    for (DetectionModel model :
        List.of(
            new Falling(Optional.of(new Scatter(0.2, 0.3))),
            new Falling(Optional.of(new Scatter(0.2, 0.1, 0.05, 0.5))),
            new Jump(Optional.of(new Scatter(0.2, 0.1))))) {
      Detection detection = Detection.by(DetectionRule.parse("chance"), "x", model);
      ChanceTable table = detection.chances(0.66, ZOOM);
      for (int i = 0; i <= 100_000; i++) {
        double distance = 8.0 * i / 100_000;
        double expected = detection.chance(model.confidence(0.66, distance, 0, ZOOM));
        assertEquals(expected, table.chance(distance), 1e-8, model.name() + " at " + distance);
      }
    }
  }

  @Test
  void chanceTableDetectsAsTheModelDoes() {
    Detection detection =
        Detection.by(
            DetectionRule.parse("chance"), "x", new Falling(Optional.of(new Scatter(0.2, 0.3))));
    ChanceTable table = detection.chances(0.66, ZOOM);
    int detected = 0;
    for (int i = 0; i < 200_000; i++) {
      double distance = 8.0 * (i % 997) / 996;
      double luck = (i * 0.6180339887498949) % 1;
      boolean expected = detection.detects(1 - distance / 10, luck, 1);
      assertEquals(expected, table.detects(distance, luck, 1), distance + " " + luck);
      detected += expected ? 1 : 0;
    }
    assertTrue(detected > 50_000 && detected < 150_000, detected + " detected");
  }
}
