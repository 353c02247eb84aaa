package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.junit.jupiter.api.Test;

/** Scenarios that are written for CamSim: the ranges of their cameras. */
class StandingObjectsTest {
  private static final OpticsSpec DOME =
      new OpticsSpec("dome")
          .with(OpticsSpec.ANGLES_OF_VIEW, List.of(20.0, 60.0))
          .with(OpticsSpec.REACH, 25);

  private static CameraSpec plain(String name) {
    return camera(name, Optional.empty());
  }

  private static CameraSpec domed(String name) {
    return camera(name, Optional.of(DOME));
  }

  private static CameraSpec camera(String name, Optional<OpticsSpec> optics) {
    return new CameraSpec(name, 1, 2, 25)
        .with(CameraSpec.HEADING, 30)
        .with(CameraSpec.VIEWING_ANGLE, 60)
        .with(CameraSpec.OPTICS, optics);
  }

  private static ScenarioEvent widened(int step, String name) {
    return new ScenarioEvent.ChangeCamera(step, name, -1, -1, -1, -1, 25);
  }

  @Test
  void onlyACameraWithOpticsGetsTheRangeThatCamSimWouldNotLeaveIt() {
    Scenario written =
        StandingObjects.of(
            new TestScenario().camera(plain("plain")).camera(domed("domed")).scenario());
    assertEquals(List.of(plain("plain"), plain("domed")), written.cameras());
    assertEquals(List.of(widened(0, "domed")), written.events());
  }

  @Test
  void aCameraThatAnEventAddsGetsItsRangeRightAfter() {
    ScenarioEvent failed = new ScenarioEvent.FailCamera(3, "start", 1);
    Scenario written =
        StandingObjects.of(
            new TestScenario()
                .camera(plain("start"))
                .events(
                    new ScenarioEvent.AddCamera(3, domed("late")),
                    failed,
                    new ScenarioEvent.AddCamera(4, plain("later")))
                .scenario());
    assertEquals(
        List.of(
            new ScenarioEvent.AddCamera(3, plain("late")),
            widened(3, "late"),
            failed,
            new ScenarioEvent.AddCamera(4, plain("later"))),
        written.events());
  }
}
