package org.hificamsim.core.registry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.example.user.UserDetection;
import org.example.user.UserListener;
import org.example.user.UserPolicy;
import org.hificamsim.core.InputException;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.Test;

/**
 * Tests that a minimal implementation of each extension point works if it is declared as a service.
 */
class ServicesTest {
  private final Registry<DetectionModel> detections =
      new Registry<DetectionModel>("detection")
          .registerServices(DetectionModel.class, DetectionModel::name, (model, options) -> {});
  private final Registry<ZoomPolicy> policies =
      new Registry<ZoomPolicy>("policy")
          .registerServices(ZoomPolicy.class, ZoomPolicy::name, ZoomPolicy::configure);
  private final Registry<StepListener> listeners =
      new Registry<StepListener>("listener")
          .registerServices(StepListener.class, StepListener::name, (listener, options) -> {});

  @Test
  void servicesOfEachKindRunInSimulation() {
    UserListener listener = (UserListener) listeners.create("UserListener");
    Simulation simulation =
        new Simulation(
            new TestScenario()
                .zooms(0.8, 5)
                .camera(0, 0)
                .target(TestScenario.target(1, -1.5, 0, 0, 0).withMovement("org.example.Right"))
                .world(),
            Detection.of(detections.create("user:near")),
            policies.create("user-level:level=1"),
            0,
            List.of(listener));
    simulation.run(6);
    assertEquals(1.5, simulation.network().targetX(0));
    assertEquals(1, simulation.network().view(0));
    assertEquals(3, listener.sum(), "detected at -0.5, 0 and 0.5");
  }

  @Test
  void createsNewInstanceEachTime() {
    assertInstanceOf(UserDetection.class, detections.create("user:near"));
    assertNotSame(policies.create("user-level"), policies.create("user-level"));
  }

  @Test
  void checksAndListsOptionsLikeBuiltInParts() {
    assertEquals(
        List.of(new Options.Declared("level", "0", "the level")), policies.options("user-level"));
    InputException range =
        assertThrows(InputException.class, () -> policies.create("user-level:level=10"));
    assertEquals(
        "policy user-level: level is '10', expected a whole number from 0 to 9",
        range.getMessage());
    assertThrows(InputException.class, () -> policies.create("user-level:depth=1"));
    assertThrows(InputException.class, () -> detections.create("user:near:x=1"));
  }

  @Test
  void summaryIsTheClassName() {
    assertEquals(UserPolicy.class.getName(), policies.entries().get(0).summary());
  }

  @Test
  void rejectsServiceWithBuiltInName() {
    Registry<ZoomPolicy> taken =
        new Registry<ZoomPolicy>("policy").register("user-level", "", UserPolicy::new);
    InputException error =
        assertThrows(
            InputException.class,
            () ->
                taken.registerServices(ZoomPolicy.class, ZoomPolicy::name, ZoomPolicy::configure));
    assertTrue(error.getMessage().contains("'user-level' is registered twice"));
  }
}
