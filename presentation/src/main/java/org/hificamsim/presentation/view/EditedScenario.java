package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;

/** A scenario with cameras and walls that have been changed since it was read. */
final class EditedScenario {
  private static final String ADDED = "added-";

  private final Scenario original;
  private Scenario now;

  EditedScenario(Scenario original) {
    this.original = original;
    this.now = original;
  }

  /** The scenario as it is now. */
  Scenario now() {
    return now;
  }

  /** Makes it the one that was read again. */
  void forget() {
    now = original;
  }

  /** Moves a camera; refuses a place that is not in the field, or in a solid obstacle. */
  void move(String name, double x, double y) {
    checkPlace(x, y);
    change(name, camera -> camera.with(CameraSpec.X, x).with(CameraSpec.Y, y));
  }

  /** Turns a camera; degrees. */
  void turn(String name, double heading) {
    if (!Double.isFinite(heading)) {
      throw new InputException("heading is %s, expected degrees".formatted(heading));
    }
    change(name, camera -> camera.with(CameraSpec.HEADING, heading));
  }

  private void change(String name, UnaryOperator<CameraSpec> change) {
    now = now.withCameras(camera -> camera.name().equals(name) ? change.apply(camera) : camera);
  }

  /** Adds a camera that is like another one but for its place, after those of the start. */
  void add(String like, double x, double y) {
    checkPlace(x, y);
    CameraSpec added =
        camera(like)
            .orElseThrow()
            .with(CameraSpec.NAME, freeName())
            .with(CameraSpec.X, x)
            .with(CameraSpec.Y, y);
    List<CameraSpec> more = new ArrayList<>(now.cameras());
    more.add(added);
    now = now.with(Scenario.CAMERAS, more);
  }

  /** Adds a solid wall after the other obstacles, where it hits no camera and no target. */
  void wall(double x1, double y1, double x2, double y2) {
    checkInField(x1, y1);
    checkInField(x2, y2);
    if (x1 == x2 && y1 == y2) {
      throw new InputException(
          "both ends of the wall are (%s, %s), expected two places".formatted(x1, y1));
    }
    Obstacle wall = new Obstacle.Wall(x1, y1, x2, y2, 0);
    places()
        .filter(place -> wall.contains(place.x(), place.y()))
        .findFirst()
        .ifPresent(
            place -> {
              throw new InputException(
                  "the wall is expected off all cameras and targets, and one stands at (%s, %s)"
                      .formatted(place.x(), place.y()));
            });
    List<Obstacle> more = new ArrayList<>(now.obstacles());
    more.add(wall);
    now = now.with(Scenario.OBSTACLES, more);
  }

  /** Takes an obstacle away. */
  void remove(int number) {
    List<Obstacle> rest = new ArrayList<>(now.obstacles());
    if (number < 0 || number >= rest.size()) {
      throw new InputException(
          "obstacle is %s, expected one of the %s, from 0".formatted(number, rest.size()));
    }
    rest.remove(number);
    now = now.with(Scenario.OBSTACLES, rest);
  }

  /** Where a scenario file may have nothing solid: cameras and the starts and ways of targets. */
  private Stream<Point> places() {
    return Stream.concat(
        now.everyCamera().map(camera -> new Point(camera.x(), camera.y())),
        now.everyTarget().flatMap(EditedScenario::places));
  }

  private static Stream<Point> places(TargetSpec target) {
    return Stream.concat(
        Stream.of(new Point(target.x(), target.y())),
        target.waypoints().stream().map(point -> new Point(point.x(), point.y())));
  }

  private String freeName() {
    int number = 1;
    while (camera(ADDED + number).isPresent()) {
      number++;
    }
    return ADDED + number;
  }

  private Optional<CameraSpec> camera(String name) {
    return now.everyCamera().filter(camera -> camera.name().equals(name)).findFirst();
  }

  private void checkPlace(double x, double y) {
    checkInField(x, y);
    if (new Obstacles(now.obstacles()).containing(x, y).isPresent()) {
      throw new InputException(
          "x is %s and y is %s, expected a place off all solid obstacles".formatted(x, y));
    }
  }

  private void checkInField(double x, double y) {
    Field field = now.field();
    if (!field.contains(x, y) || Double.isNaN(x) || Double.isNaN(y)) {
      throw new InputException(
          "x is %s and y is %s, expected a place in the field".formatted(x, y));
    }
  }
}
