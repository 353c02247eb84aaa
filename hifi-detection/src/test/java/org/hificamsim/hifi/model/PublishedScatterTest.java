package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.detector.DetectorLine;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests detection by chance with the lines and scatter of Table 6.1. */
class PublishedScatterTest {
  private static final Registry<DetectionModel> MODELS = new Registry<>("detection");

  static {
    HiFiDetections.register(MODELS);
    LabDetections.register(MODELS);
  }

  private static Detection byChance(String name, String alpha) {
    return Detection.by(DetectionRule.parse("chance:alpha=" + alpha), name, MODELS.create(name));
  }

  /** Returns the PIP at which half of the targets are detected. */
  @ParameterizedTest
  @CsvSource({
    "orb-lin, .1555, .2130",
    "orb-svr-rbf, .1397, .1913",
    "orb-sr, .1207, .1653",
    "sift-lin, .3651, .5001",
    "sift-svr-rbf, .4178, .5723",
    "sift-sr, .3454, .4731",
    "surf-lin, .2157, .2955",
    "surf-svr-rbf, .1804, .2471",
    "surf-sr, .1220, .1671",
  })
  void pipOfEvenChanceDependsOnTheDetector(String name, double atFivePercent, double atOnePercent) {
    String line = "hifi:" + (name.endsWith("svr-rbf") ? name.replace("svr-rbf", "lin") : name);
    PublishedModels catalogue = PublishedModels.published();
    int dash = name.indexOf('-');
    PublishedModels.Line g =
        catalogue.line(name.substring(0, dash), name.substring(dash + 1)).orElseThrow();
    HiFiDetection any = (HiFiDetection) MODELS.create(line);
    HiFiDetection model =
        new HiFiDetection(
            name,
            any.f(),
            g.g(),
            any.optics(),
            0.5,
            g.residuals(),
            Optional.empty(),
            any.provenance());
    assertEquals(atFivePercent, half(model, "0.05"), 0.0001);
    assertEquals(atOnePercent, half(model, "0.01"), 0.0001);
  }

  private static double half(HiFiDetection model, String alpha) {
    Detection detection = Detection.by(DetectionRule.parse("chance:alpha=" + alpha), "half", model);
    assertEquals(0.5, detection.chance(detection.threshold()), 1e-12);
    DetectorLine line = (DetectorLine) model.g();
    return (detection.threshold() - line.intercept()) / line.slope();
  }

  @Test
  void detectorsOfOneAbstractionDetectDifferently() {
    ZoomLevel zoom = new ZoomLevel(3.75, 2.5, 7.5, Double.NaN, 2 * Math.PI);
    double orb = chance("hifi:orb-lin", zoom);
    double sift = chance("hifi:sift-lin", zoom);
    double surf = chance("hifi:surf-lin", zoom);
    assertEquals(0.72, orb, 0.01);
    assertEquals(0.47, surf, 0.01);
    assertEquals(0.21, sift, 0.01);
  }

  private static double chance(String name, ZoomLevel zoom) {
    Detection detection = byChance(name, "0.05");
    return detection.chance(detection.model().confidence(0.66, 3, 0, zoom));
  }

  @Test
  void fittedModelsHaveScatter() {
    for (String name : MODELS.names()) {
      if (!name.equals("hifi-literal")) {
        assertTrue(MODELS.create(name).scatter().isPresent(), name);
      }
    }
  }
}
