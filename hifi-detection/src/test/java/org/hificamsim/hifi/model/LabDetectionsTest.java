package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.DetectionModelContract;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

class LabDetectionsTest {
  private final Registry<DetectionModel> registry = registry();

  @TestFactory
  Stream<DynamicContainer> everyModelKeepsTheContract() {
    return registry.names().stream()
        .map(name -> DetectionModelContract.of(name, () -> registry.create(name)));
  }

  @Test
  void registersEveryCombinationOfTable61() {
    for (String detector : new String[] {"orb", "sift", "surf"}) {
      for (String f : new String[] {"lin", "svr-rbf", "sr"}) {
        assertTrue(registry.knows("lab:" + detector + "-" + f));
      }
    }
    assertEquals(18, registry.names().size());
  }

  @Test
  void svrModelHasItsSupportVectors() {
    SvrRbfAbstraction f = assertInstanceOf(SvrRbfAbstraction.class, model("lab:orb-svr-rbf").f());
    assertTrue(f.support().length > 100);
    assertEquals(f, model("lab:sift-svr-rbf").f());
  }

  @Test
  void labThresholdsAreConfidencesAtTheReferencePip() {
    for (String name : registry.names()) {
      HiFiDetection model = model(name);
      assertEquals(
          PublishedModels.published().threshold(model.g()), model.defaultThreshold(), name);
      assertTrue(model.provenance().source().startsWith("profile fit, "), name);
    }
  }

  private HiFiDetection model(String name) {
    return (HiFiDetection) registry.create(name);
  }

  private static Registry<DetectionModel> registry() {
    Registry<DetectionModel> registry = new Registry<>("detection");
    LabDetections.register(registry);
    return registry;
  }
}
