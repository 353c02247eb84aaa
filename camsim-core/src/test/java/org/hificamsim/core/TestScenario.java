package org.hificamsim.core;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.AgentSpec;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.MovementSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.core.scenario.Surroundings;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Waypoint;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;

/** Scenarios made in code: a field of 20 m x 20 m about the origin, unless told otherwise. */
public final class TestScenario {
  private final List<CameraSpec> cameras = new ArrayList<>();
  private final List<TargetSpec> targets = new ArrayList<>();
  private final List<ScenarioEvent> events = new ArrayList<>();
  private Field field = new Field(-10, 10, -10, 10);
  private StepOrder order = StepOrder.CAMSIM;
  private List<Double> zooms = List.of();
  private Surroundings surroundings = Surroundings.NONE;
  private double stepTime = 1;

  public TestScenario field(double minX, double maxX, double minY, double maxY) {
    field = new Field(minX, maxX, minY, maxY);
    return this;
  }

  public TestScenario order(StepOrder newOrder) {
    order = newOrder;
    return this;
  }

  public TestScenario zooms(double... radii) {
    zooms = Arrays.stream(radii).boxed().toList();
    return this;
  }

  /** Adds an all-round camera, named by its number. */
  public TestScenario camera(double x, double y) {
    return camera(camera("c" + cameras.size(), x, y, 0, 360, 5));
  }

  public TestScenario camera(CameraSpec camera) {
    cameras.add(camera);
    return this;
  }

  /** Adds a target that goes straight, identified by its number. */
  public TestScenario target(double x, double y, double heading, double speed) {
    return target(target(targets.size(), x, y, heading, speed));
  }

  /** Adds a target that does not move. */
  public TestScenario target(double x, double y) {
    return target(x, y, 0, 0);
  }

  public TestScenario target(TargetSpec target) {
    targets.add(target);
    return this;
  }

  public TestScenario events(ScenarioEvent... all) {
    events.addAll(List.of(all));
    return this;
  }

  public TestScenario surroundings(Surroundings newSurroundings) {
    surroundings = newSurroundings;
    return this;
  }

  /** Steps of another length, seconds. */
  public TestScenario stepTime(double seconds) {
    stepTime = seconds;
    return this;
  }

  public Scenario scenario() {
    return new Scenario(
        "test",
        field,
        order,
        Headings.DEGREES,
        OptionalDouble.empty(),
        Optional.empty(),
        Objective.kMin(),
        OptionalDouble.empty(),
        stepTime,
        surroundings,
        zooms,
        cameras,
        targets,
        events,
        Optional.empty(),
        Map.of());
  }

  public World world(long seed) {
    return new World(scenario(), Movements.registry(), seed);
  }

  /** The world that is not drawn at random. */
  public World world() {
    return world(0);
  }

  /**
   * @param heading degrees
   * @param angle degrees
   */
  public static CameraSpec camera(
      String name, double x, double y, double heading, double angle, double range) {
    return new CameraSpec(name, x, y, heading, angle, range, AgentSpec.NONE, Map.of());
  }

  /**
   * @param heading degrees
   */
  public static CameraSpec camera(
      String name, double x, double y, double heading, OpticsSpec optics) {
    return new CameraSpec(
        name, x, y, heading, 60, 5, AgentSpec.NONE, Optional.of(optics), Map.of());
  }

  /**
   * @param heading degrees
   */
  public static TargetSpec target(
      double features, double x, double y, double heading, double speed) {
    return target(features, x, y, heading, speed, new MovementSpec("Straight", 0, 1, List.of()));
  }

  public static TargetSpec target(
      double features, double x, double y, double heading, double speed, MovementSpec movement) {
    return new TargetSpec(
        TargetSpec.Origin.OBJECT, features, x, y, heading, speed, 0.66, movement, Map.of());
  }

  /** The same target in another size. */
  public static TargetSpec sized(TargetSpec target, double size) {
    return new TargetSpec(
        target.origin(),
        target.features(),
        target.x(),
        target.y(),
        target.heading(),
        target.speed(),
        size,
        target.movement(),
        target.extras());
  }

  /**
   * A target on a path, which starts on its first corner.
   *
   * @param corners x, y, x, y, ...
   */
  public static TargetSpec walker(
      double features, String movement, double speed, double... corners) {
    List<Waypoint> path = new ArrayList<>();
    for (int i = 0; i < corners.length; i += 2) {
      path.add(new Waypoint(corners[i], corners[i + 1]));
    }
    MovementSpec spec = new MovementSpec(movement, 0, 1, path);
    return target(features, corners[0], corners[1], 0, speed, spec);
  }
}
