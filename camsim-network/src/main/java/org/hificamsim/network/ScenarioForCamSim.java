package org.hificamsim.network;

import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * Rewrites a scenario for CamSim itself. An object with a track becomes one that stands where its
 * track begins, and is added and removed by events; the bridge moves it along its track. A camera
 * with optics gets its widest angle. If its range is 20 m or more, an event sets the range right
 * after the camera is added, since CamSim reduces a range given at once to 16 m (behaviour 6.3).
 */
public final class ScenarioForCamSim {
  /** The least range that CamSim reduces, in metres. */
  private static final double LEAST_REDUCED_RANGE = 20;

  private static final double UNCHANGED = -1;

  private ScenarioForCamSim() {}

  /** Returns the scenario for CamSim. */
  public static Scenario of(Scenario scenario) {
    Stream<ScenarioEvent> startEvents =
        scenario.cameras().stream().flatMap(camera -> rangeEvent(0, camera, scenario));
    Stream<ScenarioEvent> laterEvents =
        scenario.events().stream().flatMap(event -> rewritten(event, scenario));
    return scenario
        .with(Scenario.EVENTS, Stream.concat(startEvents, laterEvents).toList())
        .withCameras(camera -> withoutOptics(camera, scenario));
  }

  private static CameraSpec withoutOptics(CameraSpec camera, Scenario scenario) {
    double angle =
        camera.optics().map(optics -> widest(optics.anglesOfView())).orElse(camera.viewingAngle());
    return camera
        .with(CameraSpec.VIEWING_ANGLE, angle)
        .with(CameraSpec.RANGE, range(camera, scenario))
        .without(CameraSpec.OPTICS);
  }

  private static double widest(List<Double> angles) {
    return angles.stream().mapToDouble(angle -> angle).max().orElse(2 * Math.toDegrees(Math.PI));
  }

  private static double range(CameraSpec camera, Scenario scenario) {
    return camera.range() > 0 || camera.optics().isEmpty() ? camera.range() : diagonal(scenario);
  }

  private static double diagonal(Scenario scenario) {
    return Math.ceil(Math.hypot(scenario.field().width(), scenario.field().height()));
  }

  private static Stream<ScenarioEvent> rewritten(ScenarioEvent event, Scenario scenario) {
    return event instanceof ScenarioEvent.AddCamera add
        ? Stream.concat(Stream.of(event), rangeEvent(add.step(), add.camera(), scenario))
        : Stream.of(standing(event));
  }

  /** Returns the event that sets a range which CamSim would reduce; empty if it would not. */
  private static Stream<ScenarioEvent> rangeEvent(int step, CameraSpec camera, Scenario scenario) {
    double range = range(camera, scenario);
    return camera.optics().isPresent() && range >= LEAST_REDUCED_RANGE
        ? Stream.of(
            new ScenarioEvent.ChangeCamera(
                step, camera.name(), UNCHANGED, UNCHANGED, UNCHANGED, UNCHANGED, range))
        : Stream.empty();
  }

  private static ScenarioEvent standing(ScenarioEvent event) {
    return event instanceof ScenarioEvent.AddTarget add && add.target().track().isPresent()
        ? new ScenarioEvent.AddTarget(add.step(), standing(add.target()))
        : event;
  }

  private static TargetSpec standing(TargetSpec target) {
    TargetSpec standing =
        new TargetSpec(target.features(), target.x(), target.y())
            .with(TargetSpec.ORIGIN, TargetSpec.Origin.EVENT)
            .with(TargetSpec.MOVE, "");
    return target.extent().map(standing::withExtent).orElse(standing.withSize(target.size()));
  }
}
