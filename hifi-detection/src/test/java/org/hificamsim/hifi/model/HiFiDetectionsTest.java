package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.DetectionModelContract;
import org.hificamsim.hifi.HiFiDetection;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

class HiFiDetectionsTest {
  private static final List<String> DETECTORS = List.of("orb", "sift", "surf");
  private static final List<String> ABSTRACTIONS =
      List.of("lin", "sr", "svr-lin", "power", "pinhole");

  private final Registry<DetectionModel> registry = Features.registry();

  @TestFactory
  Stream<DynamicContainer> everyModelKeepsTheContract() {
    return registry.names().stream()
        .map(name -> DetectionModelContract.of(name, () -> registry.create(name)));
  }

  @Test
  void everyDetectorIsCombinedWithEveryAbstraction() {
    assertEquals(DETECTORS.size() * (ABSTRACTIONS.size() + 2) + 1, registry.names().size());
    for (String detector : DETECTORS) {
      for (String f : ABSTRACTIONS) {
        HiFiDetection own = model("hifi:" + detector + "-" + f);
        HiFiDetection measured = model("hifi:" + detector + "-" + f + "-gt");
        assertEquals(Features.abstraction(f), own.f());
        assertEquals(Features.abstraction(f), measured.f());
        assertEquals(
            PublishedModels.published()
                .line(detector, PublishedModels.GROUND_TRUTH)
                .orElseThrow()
                .g(),
            measured.g());
      }
    }
  }

  @Test
  void everyModelIsListedUnderOneName() {
    List<HiFiDetection> models =
        registry.names().stream()
            .map(registry::create)
            .filter(HiFiDetection.class::isInstance)
            .map(HiFiDetection.class::cast)
            .toList();
    Set<String> contents = new HashSet<>();
    for (HiFiDetection model : models) {
      assertTrue(contents.add(model.f() + " " + model.g()), model.name());
    }
    assertEquals("hifi:orb-power", registry.create("hifi:orb-power-gt").name(), "still understood");
    assertTrue(registry.knows("hifi:orb-power-gt"));
  }

  @Test
  void abstractionInTable61UsesItsOwnLine() {
    for (String f : List.of("lin", "sr")) {
      assertEquals(
          PublishedModels.published().line("sift", f).orElseThrow().g(),
          model("hifi:sift-" + f).g());
    }
  }

  @Test
  void abstractionOutsideTable61UsesTheGroundTruthLine() {
    for (String f : List.of("svr-lin", "power", "pinhole")) {
      assertEquals(model("hifi:surf-" + f + "-gt").g(), model("hifi:surf-" + f).g());
    }
  }

  @Test
  void referenceModelHasThePublishedThreshold() {
    assertEquals(0.0441, model("hifi:orb-lin").defaultThreshold());
    assertEquals(0.0441, registry.create("hifi-literal").defaultThreshold());
  }

  @Test
  void everyThresholdIsTheConfidenceAtTheReferencePip() {
    double threshold = 0.0441;
    double intercept = 0.026;
    double slope = 0.571;
    double pip = (threshold - intercept) / slope;
    for (String name : registry.names()) {
      if (registry.create(name) instanceof HiFiDetection model) {
        assertEquals(model.g().confidence(pip), model.defaultThreshold(), 1e-15, name);
      }
    }
  }

  @Test
  void rejectsUnknownModelAndListsKnownOnes() {
    InputException refused =
        assertThrows(InputException.class, () -> registry.create("hifi:orb-svr-rbf"));
    assertTrue(refused.getMessage().contains("unknown detection 'hifi:orb-svr-rbf'"));
    assertTrue(refused.getMessage().contains("hifi:orb-svr-lin, "));
  }

  @Test
  void modelsRejectOptions() {
    assertThrows(InputException.class, () -> registry.create("hifi:orb-lin:slope=2"));
  }

  @Test
  void everySummaryNamesItsSourcesInOneLine() {
    for (Registry.Entry<DetectionModel> entry : registry.entries()) {
      assertFalse(entry.summary().contains("\n"), entry.name());
      assertTrue(entry.summary().length() <= 100, entry.summary());
    }
    assertEquals(
        "ORB line (Table 6.1) on the multiple linear regression (Eq 4.4)",
        registry.entries().get(0).summary());
    assertEquals("Table 6.1", model("hifi:orb-sr").provenance().remarks().get("detector line"));
  }

  private HiFiDetection model(String name) {
    return (HiFiDetection) registry.create(name);
  }
}
