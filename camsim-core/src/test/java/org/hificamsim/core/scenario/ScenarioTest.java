package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.junit.jupiter.api.Test;

/** Tests that a change of one property of a scenario keeps all others. */
class ScenarioTest {
  private static final CameraSpec LATER = TestScenario.camera("later", 1, 2, 30, 90, 5);

  private final Scenario scenario =
      new TestScenario()
          .camera(0, 0)
          .target(1, 1)
          .events(
              new ScenarioEvent.AddCamera(2, LATER),
              new ScenarioEvent.AddTarget(3, TestScenario.target(9, 2, 2, 0, 1)),
              new ScenarioEvent.FailRegistration(4, 1))
          .scenario();

  @Test
  void changeOfCameraLeavesOriginalUnchanged() {
    CameraSpec added = LATER.with(CameraSpec.NAME, "added").with(CameraSpec.X, 3);
    assertEquals("later", LATER.name());
    assertEquals(TestScenario.camera("added", 3, LATER.y(), LATER.heading(), 90, 5), added);
    assertEquals(LATER, added.with(CameraSpec.NAME, "later").with(CameraSpec.X, LATER.x()));
  }

  @Test
  void copiesGivenLists() {
    List<CameraSpec> cameras = new ArrayList<>(List.of(LATER));
    Scenario changed = scenario.with(Scenario.CAMERAS, cameras);
    cameras.clear();
    assertEquals(List.of(LATER), changed.cameras());
    assertEquals(scenario.events(), changed.events());
  }

  @Test
  void withCamerasChangesLaterCamerasToo() {
    Scenario changed =
        scenario.withCameras(camera -> camera.with(CameraSpec.NAME, camera.name() + "!"));
    assertEquals("c0!", changed.cameras().get(0).name());
    List<ScenarioEvent> events = scenario.events();
    assertEquals(
        List.of(
            new ScenarioEvent.AddCamera(2, LATER.with(CameraSpec.NAME, "later!")),
            events.get(1),
            events.get(2)),
        changed.events());
    assertEquals(scenario, changed.withCameras(ScenarioTest::withoutMark));
  }

  private static CameraSpec withoutMark(CameraSpec camera) {
    return camera.with(CameraSpec.NAME, camera.name().replace("!", ""));
  }

  @Test
  void withTargetsChangesLaterTargetsToo() {
    Scenario changed = scenario.withTargets(target -> target.with(TargetSpec.SPEED, 7));
    assertEquals(7, changed.targets().get(0).speed());
    ScenarioEvent.AddTarget later = (ScenarioEvent.AddTarget) changed.events().get(1);
    assertEquals(TestScenario.target(9, 2, 2, 0, 7), later.target());
    assertEquals(scenario.events().get(0), changed.events().get(0));
    assertEquals(scenario.events().get(2), changed.events().get(2));
  }

  @Test
  void keepsGivenHeightAndRadii() {
    Scenario high = scenario.with(Scenario.NAME, "high").with(Scenario.MOUNT_HEIGHT, 3);
    assertEquals("high", high.name());
    assertEquals(OptionalDouble.of(3), high.mountHeight());
    assertEquals(List.of(2.0, 5.0), scenario.with(Scenario.ZOOMS, List.of(2.0, 5.0)).zooms());
    assertEquals(
        scenario, scenario.with(Scenario.ZOOMS, List.of(2.0)).with(Scenario.ZOOMS, List.of()));
  }

  @Test
  void convertsHeadingsOnlyFromDegrees() {
    assertEquals(Math.PI / 2, Headings.DEGREES.radians(90));
    assertEquals(90, Headings.AS_RADIANS.radians(90));
  }
}
