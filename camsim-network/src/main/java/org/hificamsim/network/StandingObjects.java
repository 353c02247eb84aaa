package org.hificamsim.network;

import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * A scenario as CamSim itself reads it: who follows a track is an object that comes and goes by
 * events and stands where its track begins. In CamSim the bridge has it follow the track. A camera
 * with optics has its widest angle, and a range of 20 m and more is set by an event right after it
 * has come, since CamSim makes 16 m of it otherwise, as we do without optics (behaviour 6.3).
 */
public final class StandingObjects {
  private static final double CLAMPED = 20; // m
  private static final double AS_IT_IS = -1;

  private StandingObjects() {}

  /** The scenario for CamSim. */
  public static Scenario of(Scenario scenario) {
    Stream<ScenarioEvent> ofTheStart =
        scenario.cameras().stream().flatMap(camera -> widened(0, camera, scenario));
    Stream<ScenarioEvent> later =
        scenario.events().stream().flatMap(event -> seen(event, scenario));
    return scenario
        .with(Scenario.EVENTS, Stream.concat(ofTheStart, later).toList())
        .withCameras(camera -> withoutOptics(camera, scenario));
  }

  private static CameraSpec withoutOptics(CameraSpec camera, Scenario scenario) {
    double angle =
        camera.optics().map(one -> widest(one.anglesOfView())).orElse(camera.viewingAngle());
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

  private static Stream<ScenarioEvent> seen(ScenarioEvent event, Scenario scenario) {
    return event instanceof ScenarioEvent.AddCamera add
        ? Stream.concat(Stream.of(event), widened(add.step(), add.camera(), scenario))
        : Stream.of(standing(event));
  }

  /** The event that gives a camera with optics a range that CamSim would not leave it. */
  private static Stream<ScenarioEvent> widened(int step, CameraSpec camera, Scenario scenario) {
    double range = range(camera, scenario);
    return camera.optics().isPresent() && range >= CLAMPED
        ? Stream.of(
            new ScenarioEvent.ChangeCamera(
                step, camera.name(), AS_IT_IS, AS_IT_IS, AS_IT_IS, AS_IT_IS, range))
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
