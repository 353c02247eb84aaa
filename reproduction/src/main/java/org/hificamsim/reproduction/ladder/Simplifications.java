package org.hificamsim.reproduction.ladder;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.OpticsLaw;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.Surroundings;
import org.hificamsim.core.scenario.TargetSpec;

/**
 * Simplified scenarios. Each method removes what the one above it removes, and one thing more; the
 * scenario is named after what it still has.
 */
final class Simplifications {
  private static final double ALL_ROUND = 360;

  private Simplifications() {}

  /** Targets hide none, and all have one size: the mean of all. */
  static Scenario occlusion(Scenario scenario) {
    Surroundings around = scenario.surroundings();
    return withOneSize(scenario).withSurroundings(around.with(Surroundings.NONE.occlusion()));
  }

  private static Scenario withOneSize(Scenario scenario) {
    double size = everyTarget(scenario).mapToDouble(TargetSpec::size).average().orElse(Double.NaN);
    return named("walls", scenario, scenario.withTargets(target -> target.withSize(size)));
  }

  private static Stream<TargetSpec> everyTarget(Scenario scenario) {
    return Stream.concat(
        scenario.targets().stream(),
        scenario.events().stream()
            .filter(ScenarioEvent.AddTarget.class::isInstance)
            .map(event -> ((ScenarioEvent.AddTarget) event).target()));
  }

  /** No obstacles. */
  static Scenario walls(Scenario scenario) {
    Surroundings around = occlusion(scenario).surroundings();
    return named("time", scenario, occlusion(scenario)).withSurroundings(around.with(List.of()));
  }

  /** Moves are done at once. */
  static Scenario time(Scenario scenario) {
    return named("pan", scenario, walls(scenario))
        .withCameras(camera -> through(camera, one -> atOnce(one, one.pans())));
  }

  /** Cameras look where they are mounted to. */
  static Scenario pan(Scenario scenario) {
    return named("optics", scenario, time(scenario))
        .withCameras(camera -> through(camera, one -> atOnce(one, List.of(0.0))));
  }

  /**
   * Cameras see all round, as far as Eq 3.2 makes of the first lens from one height: the widest
   * level's radius is half the field's diagonal.
   *
   * @throws InputException when there is no lens
   */
  static Scenario lenses(Scenario scenario) {
    List<Double> tangents = tangents(scenario);
    double diagonal = Math.hypot(scenario.field().width(), scenario.field().height());
    double height = diagonal / 2 / tangents.get(tangents.size() - 1);
    return pan(scenario)
        .withMountHeight(scenario.name() + "-round", height)
        .withZooms(tangents.stream().map(tangent -> height * tangent).toList())
        .withCameras(camera -> camera.optics().map(one -> round(camera, one)).orElse(camera));
  }

  private static List<Double> tangents(Scenario scenario) {
    return scenario
        .everyCamera()
        .flatMap(camera -> camera.optics().stream())
        .filter(one -> one.law() == OpticsLaw.PINHOLE)
        .findFirst()
        .orElseThrow(() -> noLens(scenario))
        .anglesOfView()
        .stream()
        .map(angle -> StrictMath.tan(Math.toRadians(angle) / 2))
        .distinct()
        .toList();
  }

  private static InputException noLens(Scenario scenario) {
    return new InputException(
        "scenario '%s' has no camera with law=\"pinhole\", expected a lens to take away"
            .formatted(scenario.name()));
  }

  private static CameraSpec round(CameraSpec camera, OpticsSpec optics) {
    OpticsSpec round =
        new OpticsSpec(
            optics.name(),
            OpticsLaw.ROUND,
            optics.pixels(),
            List.of(),
            OptionalDouble.empty(),
            optics.pans(),
            optics.panSpeed(),
            optics.zoomTime(),
            optics.moving());
    return camera.through(round, ALL_ROUND);
  }

  private static CameraSpec through(CameraSpec camera, UnaryOperator<OpticsSpec> change) {
    return camera
        .optics()
        .map(one -> camera.through(change.apply(one), camera.viewingAngle()))
        .orElse(camera);
  }

  private static OpticsSpec atOnce(OpticsSpec optics, List<Double> pans) {
    return new OpticsSpec(
        optics.name(),
        optics.law(),
        optics.pixels(),
        optics.anglesOfView(),
        optics.reach(),
        pans,
        OptionalDouble.empty(),
        0,
        optics.moving());
  }

  private static Scenario named(String rung, Scenario scenario, Scenario changed) {
    return changed.with(scenario.name() + "-" + rung, changed.targets(), changed.events());
  }
}
