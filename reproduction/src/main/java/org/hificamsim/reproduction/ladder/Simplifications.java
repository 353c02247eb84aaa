package org.hificamsim.reproduction.ladder;

import java.util.List;
import java.util.function.UnaryOperator;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * Simplifies scenarios. Each method removes what the method above it removes, and one thing more.
 * The simplified scenario is named after the rung.
 */
final class Simplifications {
  private static final double ALL_ROUND = 360;

  private Simplifications() {}

  /** Keeps targets from hiding each other, and gives all of them the mean size. */
  static Scenario occlusion(Scenario scenario) {
    double size = scenario.everyTarget().mapToDouble(TargetSpec::size).average().orElse(Double.NaN);
    return named("walls", scenario, scenario)
        .withTargets(target -> target.withSize(size))
        .with(Scenario.OCCLUSION, Occlusion.NONE);
  }

  /** Removes all obstacles. */
  static Scenario walls(Scenario scenario) {
    return named("time", scenario, occlusion(scenario)).with(Scenario.OBSTACLES, List.of());
  }

  /** Lets cameras turn and zoom at once. */
  static Scenario time(Scenario scenario) {
    return named("pan", scenario, walls(scenario))
        .withCameras(camera -> withOptics(camera, Simplifications::atOnce));
  }

  /** Keeps cameras from turning. */
  static Scenario pan(Scenario scenario) {
    return named("optics", scenario, time(scenario))
        .withCameras(
            camera -> withOptics(camera, optics -> optics.with(OpticsSpec.PANS, List.of(0.0))));
  }

  /**
   * Lets cameras see all round. The radii follow from the first lens at one height by Eq 3.2: the
   * widest is half the diagonal of the field.
   *
   * @throws InputException when no camera has a lens
   */
  static Scenario lenses(Scenario scenario) {
    List<Double> tangents = tangents(scenario);
    double diagonal = Math.hypot(scenario.field().width(), scenario.field().height());
    double height = diagonal / 2 / tangents.get(tangents.size() - 1);
    return pan(scenario)
        .with(Scenario.NAME, scenario.name() + "-round")
        .with(Scenario.MOUNT_HEIGHT, height)
        .with(Scenario.ZOOMS, tangents.stream().map(tangent -> height * tangent).toList())
        .withCameras(camera -> camera.optics().map(optics -> round(camera, optics)).orElse(camera));
  }

  private static List<Double> tangents(Scenario scenario) {
    return scenario
        .everyCamera()
        .flatMap(camera -> camera.optics().stream())
        .filter(optics -> optics.law() == OpticsLaw.PINHOLE)
        .findFirst()
        .orElseThrow(() -> noLens(scenario))
        .anglesOfView()
        .stream()
        .map(angle -> StrictMath.tan(Math.toRadians(angle) / 2))
        .distinct()
        .toList();
  }

  private static InputException noLens(Scenario scenario) {
    return InputException.of(
        "scenario '%s' has no camera with law=\"pinhole\", expected a lens to take away",
        scenario.name());
  }

  private static CameraSpec round(CameraSpec camera, OpticsSpec optics) {
    return camera
        .with(
            CameraSpec.OPTICS,
            optics
                .with(OpticsSpec.LAW, OpticsLaw.ROUND)
                .with(OpticsSpec.ANGLES_OF_VIEW, List.of())
                .without(OpticsSpec.REACH))
        .with(CameraSpec.VIEWING_ANGLE, ALL_ROUND);
  }

  private static CameraSpec withOptics(CameraSpec camera, UnaryOperator<OpticsSpec> change) {
    return camera.with(CameraSpec.OPTICS, camera.optics().map(change));
  }

  private static OpticsSpec atOnce(OpticsSpec optics) {
    return optics.without(OpticsSpec.PAN_SPEED).with(OpticsSpec.ZOOM_TIME, 0);
  }

  private static Scenario named(String rung, Scenario scenario, Scenario changed) {
    return changed.with(Scenario.NAME, scenario.name() + "-" + rung);
  }
}
