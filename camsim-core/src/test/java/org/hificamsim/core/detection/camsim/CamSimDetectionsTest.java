package org.hificamsim.core.detection.camsim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionModelContract;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CamSimDetectionsTest {
  private static final double ALL_ROUND = Math.toRadians(360);

  @Nested
  class Standard implements DetectionModelContract {
    @Override
    public DetectionModel model() {
      return new CamSimStandardDetection();
    }

    @ParameterizedTest
    @CsvSource({"0, 0.80", "2, 0.5625", "4, 0.325", "8, -0.15"})
    void fallsWithTheZoomRadiusAsInEquation62(double radius, double value) {
      assertEquals(value, model().confidence(1, 1, 0, zoom(radius, 8)), 1e-15);
      assertEquals(value, model().confidence(9, 0, 0, zoom(radius, 8)), 1e-15);
    }

    @Test
    void detectsNothingAtWidestZoomAndThresholdZero() {
      Detection detection = new Detection(model(), 0);
      assertEquals(0, detection.distances(1, zoom(8, 8)).intervals());
      assertEquals(1, detection.distances(1, zoom(6, 8)).intervals());
    }
  }

  @Nested
  class Range implements DetectionModelContract {
    @Override
    public DetectionModel model() {
      return new CamSimRangeDetection();
    }

    @ParameterizedTest
    @CsvSource({"5, 3, 0.8", "2, 1, 6.975", "8, 8, 0.07265625", "10, 9, 0.00833333333333333"})
    void fallsWithZoomRadiusAndDistance(double radius, double distance, double value) {
      assertEquals(value, model().confidence(1, distance, 0, zoom(radius, 10)), 1e-15);
    }

    @Test
    void isNeverBelowZero() {
      assertEquals(0, model().confidence(1, 19, 0, zoom(19, 19)));
    }

    @Test
    void isCertainWithinANanometre() {
      assertEquals(1, model().confidence(1, 0, 0, zoom(5, 5)));
      assertEquals(1, model().confidence(1, Math.nextDown(1e-9), 0, zoom(5, 5)));
      assertEquals(2.85e9, model().confidence(1, 1e-9, 0, zoom(5, 5)), 1);
    }
  }

  @Nested
  class Visibility implements DetectionModelContract {
    @Override
    public DetectionModel model() {
      return new CamSimVisibilityDetection();
    }

    @ParameterizedTest
    @CsvSource({
      // d, offAxis, angle, R
      "0, 0, 360, 10, 1",
      "10, 0, 360, 10, 0.1",
      "10, 3.1, 360, 10, 0.1",
      "5, 0, 360, 10, 0.18181818181818182",
      "5, 0, 90, 10, 0.18181818181818182",
      "5, 0.39269908169872414, 90, 10, 0.09090909090909091",
      "0.25, 0, 90, 0.5, 1.3333333333333333",
    })
    void isDistancePartTimesAnglePart(
        double distance, double offAxis, double angle, double radius, double value) {
      ZoomLevel zoom = new ZoomLevel(radius, radius, radius, Double.NaN, Math.toRadians(angle));
      assertEquals(value, model().confidence(1, distance, offAxis, zoom), 1e-15);
    }

    @Test
    void isZeroOutsideHalfAngle() {
      ZoomLevel narrow = new ZoomLevel(5, 5, 5, Double.NaN, 1);
      assertEquals(0, model().confidence(1, 2, Double.NaN, narrow));
      assertEquals(0, model().confidence(1, 2, 0.5, narrow));
      assertTrue(model().confidence(1, 2, Math.nextDown(0.5), narrow) > 0);
      assertEquals(0, model().confidence(1, 0, Double.NaN, zoom(5, 5)), "all round, too");
    }

    @Test
    void defaultThresholdIsTheSmallestNumber() {
      assertEquals(Double.MIN_VALUE, model().defaultThreshold());
    }
  }

  @Nested
  class Geometric implements DetectionModelContract {
    @Override
    public DetectionModel model() {
      return new GeometricDetection();
    }
  }

  @Test
  void registersAllModelsUnderTheirNames() {
    Registry<DetectionModel> registry = CamSimDetections.register(new Registry<>("detection"));
    assertEquals(List.of("camsim-standard", "camsim-range", "camsim-visibility"), registry.names());
    registry.names().forEach(name -> assertEquals(name, registry.create(name).name()));
  }

  @ParameterizedTest
  @CsvSource({"-0.5, 0", "0, 0", "0.25, 0.25", "1, 1", "7, 1", "NaN, 0", "Infinity, 1"})
  void clampsReportedConfidences(double value, double clamped) {
    assertEquals(clamped, DetectionModel.clamp(value));
  }

  private static ZoomLevel zoom(double radius, double widest) {
    return new ZoomLevel(radius, 1, widest, Double.NaN, ALL_ROUND);
  }
}
