package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests the share of the field within reach of a camera at its widest zoom (Table 7.1), by
 * sampling.
 */
class AreaCoverageTest {
  private static final int SAMPLES = 200_000;

  @ParameterizedTest
  @CsvSource({
    "lattice-random, 9, 1.00",
    "lattice-scripted, 9, 1.00",
    "ring-random, 8, 0.92",
    "ring-scripted, 8, 0.92",
    "cluster-random, 14, 0.66",
    "cluster-scripted, 14, 0.66",
    "cluster-scripted-origin, 14, 0.66",
  })
  void areaCoverageEqualsPublishedValue(String name, int cameras, double published) {
    Scenario scenario = ScenarioReader.read(Cli.scenario(name), movement -> true, warning -> {});
    assertEquals(cameras, scenario.cameras().size());
    assertEquals(published, sampled(scenario), 0.0075);
  }

  private static double sampled(Scenario scenario) {
    Random random = new Random(1);
    Field field = scenario.field();
    int covered = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double x = field.minX() + random.nextDouble() * field.width();
      double y = field.minY() + random.nextDouble() * field.height();
      covered += withinReach(scenario, x, y) ? 1 : 0;
    }
    return (double) covered / SAMPLES;
  }

  private static boolean withinReach(Scenario scenario, double x, double y) {
    double widest = scenario.zooms().get(scenario.zooms().size() - 1);
    for (CameraSpec camera : scenario.cameras()) {
      if (Math.hypot(x - camera.x(), y - camera.y()) <= widest) {
        return true;
      }
    }
    return false;
  }
}
