package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.hifi.optics.Optics;

/** Changes the targets or optics of a scenario, and names it after the change. */
final class ChangedWorld {
  private static final long SEED = 71;

  /** The share of the field, around its middle, that contains drawn positions. */
  private static final double INSIDE = 0.8;

  private static final double FULL_TURN = 360;

  private ChangedWorld() {}

  /** Gives all targets another size q, in metres. */
  static Scenario withSize(Scenario scenario, double size) {
    return scenario
        .withTargets(target -> target.withSize(size))
        .with(Scenario.NAME, scenario.name() + "-q" + size);
  }

  /** Gives all targets another speed, metres a step. */
  static Scenario withSpeed(Scenario scenario, double speed) {
    return scenario
        .withTargets(target -> target.with(TargetSpec.SPEED, speed))
        .with(Scenario.NAME, scenario.name() + "-v" + speed);
  }

  /** Scales the radii of the zoom levels to another widest radius, in metres. */
  static Scenario withWidestRadius(Scenario scenario, double radius) {
    List<Double> radii = scenario.zooms();
    double widest = radii.get(radii.size() - 1);
    return scenario
        .with(Scenario.ZOOMS, radii.stream().map(old -> radius * (old / widest)).toList())
        .with(Scenario.NAME, scenario.name() + "-r" + radius);
  }

  /**
   * Moves all cameras to the height at which the narrowest zoom level has a focal length (Eqs 3.1,
   * 3.2).
   *
   * @param focalLength the focal length in metres, above 0
   */
  static Scenario withFocalLength(Scenario scenario, Optics optics, double focalLength) {
    double height = 2 * focalLength * scenario.zooms().get(0) / optics.sensorWidth();
    return scenario
        .with(Scenario.NAME, scenario.name() + "-z" + focalLength)
        .with(Scenario.MOUNT_HEIGHT, height);
  }

  /**
   * Changes the number of targets: keeps the first ones of the file, and adds others of the same
   * kind. Those that follow a script start on corners where no other starts, then halfway between
   * corners; others start at drawn positions, which are the same in every run.
   */
  static Scenario withTargets(Scenario scenario, int number) {
    boolean isScripted = scenario.targets().isEmpty();
    List<TargetSpec> targets =
        new ArrayList<>(isScripted ? scenario.everyTarget().toList() : scenario.targets());
    while (targets.size() > number) {
      targets.remove(targets.size() - 1);
    }
    SplittableRandom random = new SplittableRandom(SEED);
    while (targets.size() < number) {
      targets.add(
          isScripted ? onScript(targets) : anywhere(scenario, targets.get(0), targets, random));
    }
    String name = scenario.name() + "-" + number + "-targets";
    Scenario named = scenario.with(Scenario.NAME, name);
    return isScripted
        ? named.with(Scenario.TARGETS, List.of()).with(Scenario.EVENTS, events(targets))
        : named.with(Scenario.TARGETS, targets);
  }

  private static List<ScenarioEvent> events(List<TargetSpec> targets) {
    return targets.stream()
        .map(target -> (ScenarioEvent) new ScenarioEvent.AddTarget(0, target))
        .toList();
  }

  private static TargetSpec anywhere(
      Scenario scenario, TargetSpec model, List<TargetSpec> others, SplittableRandom random) {
    double x = INSIDE * (random.nextDouble() - 0.5) * scenario.field().width();
    double y = INSIDE * (random.nextDouble() - 0.5) * scenario.field().height();
    return next(
            model,
            others,
            x + (scenario.field().minX() + scenario.field().maxX()) / 2,
            y + (scenario.field().minY() + scenario.field().maxY()) / 2)
        .with(TargetSpec.HEADING, random.nextDouble() * FULL_TURN);
  }

  private static TargetSpec onScript(List<TargetSpec> others) {
    TargetSpec model = others.get(0);
    List<Waypoint> path = path(model.waypoints(), others);
    return next(model, others, path.get(0).x(), path.get(0).y()).with(TargetSpec.WAYPOINTS, path);
  }

  /** The same path from the first corner, or middle of a side, where no target starts yet. */
  private static List<Waypoint> path(List<Waypoint> corners, List<TargetSpec> others) {
    List<List<Waypoint>> paths = new ArrayList<>();
    for (int side = 0; side < corners.size(); side++) {
      List<Waypoint> turned = new ArrayList<>(corners);
      Collections.rotate(turned, -side);
      paths.add(side, turned);
      List<Waypoint> halfway = new ArrayList<>(turned);
      Collections.rotate(halfway, -1);
      halfway.add(0, middle(turned.get(0), turned.get(1)));
      paths.add(halfway);
    }
    return paths.stream()
        .filter(path -> others.stream().noneMatch(other -> startsAt(other, path.get(0))))
        .findFirst()
        .orElse(corners);
  }

  private static boolean startsAt(TargetSpec target, Waypoint position) {
    return target.waypoints().get(0).equals(position);
  }

  private static Waypoint middle(Waypoint a, Waypoint b) {
    return new Waypoint((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
  }

  private static TargetSpec next(TargetSpec model, List<TargetSpec> others, double x, double y) {
    return model
        .with(TargetSpec.FEATURES, others.get(others.size() - 1).features() + 1)
        .with(TargetSpec.X, x)
        .with(TargetSpec.Y, y)
        .withSize(model.size());
  }
}
