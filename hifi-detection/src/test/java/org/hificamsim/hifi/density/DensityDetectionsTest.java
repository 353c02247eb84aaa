package org.hificamsim.hifi.density;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.DetectionModelContract;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DensityDetectionsTest {
  private static final double EXACT = 1e-12;

  private final Registry<DetectionModel> registry = new Registry<>("detection");

  DensityDetectionsTest() {
    DensityDetections.register(registry);
  }

  @TestFactory
  Stream<DynamicContainer> keepsTheContract() {
    return Stream.concat(
            registry.names().stream(), Stream.of("dori-2014:level=identify", "ttpf:task=identify"))
        .map(name -> DetectionModelContract.of(name, () -> registry.create(name)));
  }

  /** Distances are W / (2 rho tan(theta / 2)), computed by hand. */
  @ParameterizedTest
  @CsvSource({
    "dori-2014, 60, 1920, 66.51",
    "dori-2014:level=observe, 60, 1920, 26.60",
    "dori-2014:level=recognise, 60, 1920, 13.30",
    "dori-2014:level=identify, 60, 1920, 6.651",
    "dori-2014:level=identify, 90, 640, 1.280",
    "oodpcvs-2025, 90, 3840, 96.00",
    "oodpcvs-2025:level=outline, 90, 3840, 48.00",
    "oodpcvs-2025:level=discern, 90, 3840, 24.00",
    "oodpcvs-2025:level=perceive, 90, 3840, 15.36",
    "oodpcvs-2025:level=characterise, 90, 3840, 7.680",
    "oodpcvs-2025:level=validate, 90, 3840, 3.840",
    "oodpcvs-2025:level=scrutinise, 90, 3840, 1.280"
  })
  void standardDetectsUpToItsPixelDensity(String name, double angle, int pixels, double reach) {
    Detection detection = Detection.of(registry.create(name));
    ZoomLevel zoom = lens(angle, pixels);
    assertEquals(reach, Math.sqrt(detection.distances(0.66, zoom).to(0)), reach / 2000);
    assertEquals(detection.distances(0.66, zoom), detection.distances(5, zoom), "of any size");
  }

  /** Checks published values of the function. */
  @ParameterizedTest
  @CsvSource({"0, 0", "1, 0.5", "1.452, 0.80", "2.041, 0.95"})
  void acquisitionHasThePublishedProbabilities(double ratio, double probability) {
    assertEquals(probability, DensityDetections.probability(ratio), 5e-4);
  }

  @Test
  void acquisitionCountsTwoPixelsPerCycle() {
    DetectionModel detect = registry.create("ttpf");
    DetectionModel identify = registry.create("ttpf:task=identify");
    ZoomLevel zoom = lens(90, 640);
    // 640 / (2 * 160 m) = 2 pixels per metre: a target of 1 m has one cycle, N50 of detection
    assertEquals(0.5, detect.confidence(1, 160, 0, zoom), EXACT);
    assertEquals(0.5, identify.confidence(6.4, 160, 0, zoom), EXACT);
    assertTrue(identify.confidence(1, 160, 0, zoom) < 0.01);
  }

  @Test
  void modelOpticsGiveTheAngleWithoutLens() {
    DetectionModel model = registry.create("dori-2014:level=identify");
    ZoomLevel narrow = new ZoomLevel(100, 2.5, 100, Double.NaN, 2 * Math.PI);
    ZoomLevel high = new ZoomLevel(100, 2.5, 100, 5, 2 * Math.PI);
    double one = model.confidence(0.66, 50, 0, narrow);
    assertTrue(one > 0 && one < 1, "value " + one);
    // Eq 3.2: tan(theta / 2) is radius over height
    assertEquals(1920 / (2 * 50 * (100 / 5.0)) / 250, model.confidence(0.66, 50, 0, high), EXACT);
  }

  @Test
  void nameShowsTheLevelUnlessDefault() {
    assertEquals("dori-2014", registry.create("dori-2014:level=detect").name());
    assertEquals("dori-2014:level=observe", registry.create("dori-2014:level=observe").name());
    assertFalse(registry.create("ttpf").equals(registry.create("ttpf:task=orient")), "two models");
    InputException error =
        assertThrows(InputException.class, () -> registry.create("dori-2014:level=see"));
    assertTrue(
        error.getMessage().contains("detect, observe, recognise, identify"), error::getMessage);
  }

  @ParameterizedTest
  @CsvSource({
    "dori-2014, WHOLE",
    "dori-2014:level=observe, WHOLE",
    "dori-2014:level=recognise, HEAD",
    "oodpcvs-2025:level=discern, WHOLE",
    "oodpcvs-2025:level=perceive, HEAD",
    "ttpf:task=orient, WHOLE",
    "ttpf:task=recognise, HEAD",
    "ttpf:task=identify, HEAD"
  })
  void recognitionNeedsTheHead(String name, Seen seen) {
    assertEquals(seen, registry.create(name).seen());
  }

  @ParameterizedTest
  @CsvSource({
    "oodpcvs-2025:level=characterise, characterise (formerly identify)",
    "oodpcvs-2025:level=perceive, perceive (formerly recognise)",
    "oodpcvs-2025:level=discern, discern",
    "oodpcvs-2025, overview",
    "dori-2014, detect",
    "dori-2014:level=observe@0.5, observe",
    "ttpf:task=orient, ttpf:task=orient"
  })
  void levelNamesShowTheirFormerNames(String detection, String words) {
    assertEquals(words, DensityDetections.levelName(detection));
  }

  private static ZoomLevel lens(double angle, int pixels) {
    double radians = Math.toRadians(angle);
    return new ZoomLevel(200, 200, 200, Double.NaN, radians, radians, pixels);
  }
}
