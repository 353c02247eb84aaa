package org.hificamsim.presentation.view;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;

/** A scenario that has been changed since it was read, with what undo and redo need. */
final class EditedScenario {
  private static final String ADDED = "added-";
  private static final int MOST_UNDONE = 200;

  private final Scenario original;
  private final Deque<Scenario> past = new ArrayDeque<>();
  private final Deque<Scenario> undone = new ArrayDeque<>();
  private Scenario now;
  private String moved = "";

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
    become("", original);
  }

  /**
   * Notes a change.
   *
   * @param move the camera that is moved or turned, empty for other changes: however long one
   *     camera is dragged, it is one change
   */
  private void become(String move, Scenario changed) {
    if (move.isEmpty() || !move.equals(moved)) {
      past.push(now);
    }
    if (past.size() > MOST_UNDONE) {
      past.removeLast();
    }
    undone.clear();
    moved = move;
    now = changed;
  }

  /** Takes the last change back. */
  void undo() {
    step(past, undone, "undo");
  }

  /** Makes the change again that was taken back last. */
  void redo() {
    step(undone, past, "redo");
  }

  private void step(Deque<Scenario> from, Deque<Scenario> to, String what) {
    if (from.isEmpty()) {
      throw new InputException("no change, expected one to " + what);
    }
    to.push(now);
    now = from.pop();
    moved = "";
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
    become(
        name,
        now.withCameras(camera -> camera.name().equals(name) ? change.apply(camera) : camera));
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
    become("", now.with(Scenario.CAMERAS, more));
  }

  /** Puts a camera in the place of the one of its name; or one more, under a free name. */
  void put(CameraSpec camera, boolean more) {
    List<CameraSpec> all = new ArrayList<>(now.cameras());
    all.add(camera.with(CameraSpec.NAME, freeName()));
    become(
        "",
        more
            ? now.with(Scenario.CAMERAS, all)
            : now.withCameras(one -> one.name().equals(camera.name()) ? camera : one));
  }

  /** Takes a camera away, with the events that it has. */
  void removeCamera(int number) {
    String name = element(now.everyCamera().toList(), number, "camera").name();
    Scenario rest = without(Scenario.CAMERAS, number, ScenarioEvent.AddCamera.class);
    List<ScenarioEvent> events =
        rest.events().stream()
            .filter(event -> !event.existingCamera().equals(Optional.of(name)))
            .toList();
    become("", rest.with(Scenario.EVENTS, events));
  }

  /** Takes a target away. */
  void removeTarget(int number) {
    element(now.everyTarget().toList(), number, "target");
    become("", without(Scenario.TARGETS, number, ScenarioEvent.AddTarget.class));
  }

  /** Adds a solid wall after the other obstacles, where it hits no camera and no target. */
  void wall(double x1, double y1, double x2, double y2) {
    checkInField(x1, y1);
    checkInField(x2, y2);
    if (x1 == x2 && y1 == y2) {
      throw InputException.of("both ends of the wall are (%s, %s), expected two places", x1, y1);
    }
    Obstacle wall = new Obstacle.Wall(x1, y1, x2, y2, 0);
    places()
        .filter(place -> wall.contains(place.x(), place.y()))
        .findFirst()
        .ifPresent(
            place -> {
              throw InputException.of(
                  "the wall is expected off all cameras and targets, and one stands at (%s, %s)",
                  place.x(), place.y());
            });
    List<Obstacle> more = new ArrayList<>(now.obstacles());
    more.add(wall);
    become("", now.with(Scenario.OBSTACLES, more));
  }

  /** Takes an obstacle away. */
  void removeObstacle(int number) {
    element(now.obstacles(), number, "obstacle");
    become("", now.with(Scenario.OBSTACLES, without(now.obstacles(), number)));
  }

  private static <T> T element(List<T> all, int number, String what) {
    if (number < 0 || number >= all.size()) {
      throw InputException.of("%s is %s, expected one of the %s, from 0", what, number, all.size());
    }
    return all.get(number);
  }

  /**
   * Without an element of the start, or the event that adds one later.
   *
   * @param number counts first the ones of the start, then those that events add
   */
  private <T> Scenario without(
      Property<Scenario, List<T>> list, int number, Class<? extends ScenarioEvent> adds) {
    List<T> start = now.get(list);
    if (number < start.size()) {
      return now.with(list, without(start, number));
    }
    ScenarioEvent event =
        now.events().stream().filter(adds::isInstance).toList().get(number - start.size());
    return now.with(Scenario.EVENTS, without(now.events(), now.events().indexOf(event)));
  }

  private static <T> List<T> without(List<T> list, int number) {
    List<T> rest = new ArrayList<>(list);
    rest.remove(number);
    return rest;
  }

  /** The names of targets whose way from waypoint to waypoint leads through a solid obstacle. */
  List<String> blocked() {
    Obstacles solid = new Obstacles(now.obstacles());
    return now.everyTarget()
        .filter(target -> isBlocked(target.waypoints(), solid))
        .map(TargetSpec::name)
        .toList();
  }

  private static boolean isBlocked(List<Waypoint> way, Obstacles obstacles) {
    return IntStream.range(0, way.size())
        .anyMatch(
            i -> {
              Waypoint from = way.get(i);
              Waypoint to = way.get((i + 1) % way.size());
              return obstacles.transmittance(from.x(), from.y(), to.x(), to.y()) == 0;
            });
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

  /** The camera of a name. */
  Optional<CameraSpec> camera(String name) {
    return now.everyCamera().filter(camera -> camera.name().equals(name)).findFirst();
  }

  private void checkPlace(double x, double y) {
    checkInField(x, y);
    if (new Obstacles(now.obstacles()).containing(x, y).isPresent()) {
      throw InputException.of(
          "x is %s and y is %s, expected a place off all solid obstacles", x, y);
    }
  }

  private void checkInField(double x, double y) {
    Field field = now.field();
    if (!field.contains(x, y) || Double.isNaN(x) || Double.isNaN(y)) {
      throw InputException.of("x is %s and y is %s, expected a place in the field", x, y);
    }
  }
}
