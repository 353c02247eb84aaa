package org.hificamsim.core;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;

/** Scenarios made in code: by default with a field of 20 m x 20 m around the origin. */
public final class TestScenario {
  private final List<CameraSpec> cameras = new ArrayList<>();
  private final List<TargetSpec> targets = new ArrayList<>();
  private final List<ScenarioEvent> events = new ArrayList<>();
  private Scenario settings = new Scenario("test", new Field(-10, 10, -10, 10));

  public TestScenario field(double minX, double maxX, double minY, double maxY) {
    settings = new Scenario("test", new Field(minX, maxX, minY, maxY));
    return this;
  }

  /**
   * Sets any property except cameras, targets and events; if {@link #field} is called, it has to
   * come first.
   */
  public <T> TestScenario with(Property<Scenario, T> property, T value) {
    settings = settings.with(property, value);
    return this;
  }

  public TestScenario order(StepOrder order) {
    return with(Scenario.ORDER, order);
  }

  public TestScenario zooms(double... radii) {
    return with(Scenario.ZOOMS, Arrays.stream(radii).boxed().toList());
  }

  public TestScenario obstacles(Obstacle... obstacles) {
    return with(Scenario.OBSTACLES, List.of(obstacles));
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

  public TestScenario events(ScenarioEvent... added) {
    events.addAll(List.of(added));
    return this;
  }

  /** Sets the length of a step, in seconds. */
  public TestScenario stepTime(double seconds) {
    return with(Scenario.STEP_TIME, seconds);
  }

  public Scenario scenario() {
    return settings
        .with(Scenario.CAMERAS, cameras)
        .with(Scenario.TARGETS, targets)
        .with(Scenario.EVENTS, events);
  }

  public World world(long seed) {
    return new World(scenario(), Movements.registry(), seed);
  }

  /** Returns the world of seed 0. */
  public World world() {
    return world(0);
  }

  /**
   * @param heading the heading, in degrees
   * @param angle the angle, in degrees
   */
  public static CameraSpec camera(
      String name, double x, double y, double heading, double angle, double range) {
    return new CameraSpec(name, x, y, range)
        .with(CameraSpec.HEADING, heading)
        .with(CameraSpec.VIEWING_ANGLE, angle);
  }

  /**
   * @param heading the heading, in degrees
   */
  public static CameraSpec camera(
      String name, double x, double y, double heading, OpticsSpec optics) {
    return camera(name, x, y, heading, 60, 5).with(CameraSpec.OPTICS, optics);
  }

  /**
   * @param heading the heading, in degrees
   */
  public static TargetSpec target(
      double features, double x, double y, double heading, double speed) {
    return new TargetSpec(features, x, y)
        .with(TargetSpec.HEADING, heading)
        .with(TargetSpec.SPEED, speed);
  }

  /**
   * Returns a target that starts on the first corner of its path.
   *
   * @param corners the coordinates of the corners: x, y, x, y, ...
   */
  public static TargetSpec walker(
      double features, String movement, double speed, double... corners) {
    List<Waypoint> path = new ArrayList<>();
    for (int i = 0; i < corners.length; i += 2) {
      path.add(new Waypoint(corners[i], corners[i + 1]));
    }
    return target(features, corners[0], corners[1], 0, speed)
        .with(TargetSpec.MOVE, movement)
        .with(TargetSpec.WAYPOINTS, path);
  }
}
