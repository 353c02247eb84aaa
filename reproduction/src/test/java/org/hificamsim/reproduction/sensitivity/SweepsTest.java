package org.hificamsim.reproduction.sensitivity;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;
import org.junit.jupiter.api.Test;

class SweepsTest {
  private static final List<ParameterSweep> ALL =
      new Sweeps(Map.of(), Catalogue.load()::detection).all();

  @Test
  void everySweepHasOneDefaultAndOtherValues() {
    for (ParameterSweep sweep : ALL) {
      long defaults = sweep.variants().stream().filter(Variant::isDefault).count();
      assertEquals(1, defaults, sweep.parameter());
      assertEquals(
          sweep.variants().size(),
          sweep.variants().stream().map(Variant::value).distinct().count(),
          sweep.parameter());
    }
  }

  @Test
  void defaultsAreThoseOfTheModelsAndScenarios() {
    Variant variant = ALL.get(0).variants().get(0);
    assertEquals(
        Catalogue.load().detection("hifi:orb-lin").defaultThreshold(),
        Double.parseDouble(defaultValue("threshold-hifi")));
    assertEquals(
        variant.camsim().threshold(), Double.parseDouble(defaultValue("threshold-camsim")));
    assertEquals(TargetSpec.DEFAULT_SIZE, Double.parseDouble(defaultValue("size")));
    assertEquals(
        PublishedModels.published().optics().longestFocalLength(),
        Double.parseDouble(defaultValue("optics")));
  }

  private static String defaultValue(String parameter) {
    return ALL.stream()
        .filter(sweep -> sweep.parameter().equals(parameter))
        .flatMap(sweep -> sweep.variants().stream())
        .filter(Variant::isDefault)
        .findFirst()
        .orElseThrow()
        .value();
  }
}
