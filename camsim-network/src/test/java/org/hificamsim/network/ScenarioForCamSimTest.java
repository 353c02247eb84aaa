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

/** Tests the ranges of cameras in scenarios that are written for CamSim. */
class ScenarioForCamSimTest {
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

  private static ScenarioEvent rangeEvent(int step, String name) {
    return new ScenarioEvent.ChangeCamera(step, name, -1, -1, -1, -1, 25);
  }

  @Test
  void onlyCamerasWithOpticsGetRangeByEvent() {
    Scenario written =
        ScenarioForCamSim.of(
            new TestScenario().camera(plain("plain")).camera(domed("domed")).scenario());
    assertEquals(List.of(plain("plain"), plain("domed")), written.cameras());
    assertEquals(List.of(rangeEvent(0, "domed")), written.events());
  }

  @Test
  void cameraAddedByEventGetsItsRangeRightAfter() {
    ScenarioEvent failed = new ScenarioEvent.FailCamera(3, "start", 1);
    Scenario written =
        ScenarioForCamSim.of(
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
            rangeEvent(3, "late"),
            failed,
            new ScenarioEvent.AddCamera(4, plain("later"))),
        written.events());
  }
}
