package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalDouble;
import org.hificamsim.core.TestScenario;
import org.junit.jupiter.api.Test;

/** A scenario changed in one thing is the same in all others. */
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
  void oneMoreCameraComesAfterThoseOfTheStart() {
    CameraSpec added = LATER.named("added").standing(3, 4, 5);
    Scenario changed = scenario.withCamera(added);
    assertEquals(List.of(scenario.cameras().get(0), added), changed.cameras());
    assertEquals(TestScenario.camera("added", 3, 4, 5, 90, 5), added);
    assertEquals(scenario.events(), changed.events());
  }

  @Test
  void camerasThatComeLaterAreChangedToo() {
    Scenario changed = scenario.withCameras(camera -> camera.named(camera.name() + "!"));
    assertEquals("c0!", changed.cameras().get(0).name());
    List<ScenarioEvent> events = scenario.events();
    assertEquals(
        List.of(
            new ScenarioEvent.AddCamera(2, LATER.named("later!")), events.get(1), events.get(2)),
        changed.events());
    assertEquals(scenario, changed.withCameras(ScenarioTest::undone));
  }

  private static CameraSpec undone(CameraSpec camera) {
    return camera.named(camera.name().replace("!", ""));
  }

  @Test
  void targetsThatComeLaterAreChangedToo() {
    Scenario changed = scenario.withTargets(target -> target.withSpeed(7));
    assertEquals(7, changed.targets().get(0).speed());
    ScenarioEvent.AddTarget later = (ScenarioEvent.AddTarget) changed.events().get(1);
    assertEquals(TestScenario.target(9, 2, 2, 0, 7), later.target());
    assertEquals(scenario.events().get(0), changed.events().get(0));
    assertEquals(scenario.events().get(2), changed.events().get(2));
  }

  @Test
  void heightAndRadiiAreThoseGiven() {
    Scenario high = scenario.withMountHeight("high", 3);
    assertEquals("high", high.name());
    assertEquals(OptionalDouble.of(3), high.mountHeight());
    assertEquals(List.of(2.0, 5.0), scenario.withZooms(List.of(2.0, 5.0)).zooms());
    assertEquals(scenario, scenario.withZooms(List.of(2.0)).withoutZooms());
  }

  @Test
  void headingsAreDegreesUnlessTheyAreReadAsRadians() {
    assertEquals(Math.PI / 2, Headings.DEGREES.radians(90));
    assertEquals(90, Headings.AS_RADIANS.radians(90));
  }
}
