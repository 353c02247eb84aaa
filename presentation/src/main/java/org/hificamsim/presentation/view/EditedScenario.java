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
import org.hificamsim.core.Spelling;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.spec.Zone;

/** A scenario with the changes that a user has made, which can be undone and redone. */
final class EditedScenario {
  private static final String ADDED_PREFIX = "added-";
  private static final String ZONE_PREFIX = "zone-";
  private static final int MOST_UNDO_STEPS = 200;

  private final Scenario original;
  private final Deque<Scenario> undoSteps = new ArrayDeque<>();
  private final Deque<Scenario> redoSteps = new ArrayDeque<>();
  private Scenario current;

  /** The camera that the last change moved or turned; empty if the change was another one. */
  private String lastMoved = "";

  EditedScenario(Scenario original) {
    this.original = original;
    this.current = original;
  }

  /** The scenario with all changes. */
  Scenario current() {
    return current;
  }

  /** Restores the scenario that was read, as a change that can be undone. */
  void reset() {
    apply("", original);
  }

  /**
   * Makes a change that can be undone. Moves and turns of one camera in a row are one change.
   *
   * @param moved the camera that is moved or turned; empty for other changes
   */
  private void apply(String moved, Scenario changed) {
    if (moved.isEmpty() || !moved.equals(lastMoved)) {
      undoSteps.push(current);
    }
    if (undoSteps.size() > MOST_UNDO_STEPS) {
      undoSteps.removeLast();
    }
    redoSteps.clear();
    lastMoved = moved;
    current = changed;
  }

  /** Undoes the last change. */
  void undo() {
    step(undoSteps, redoSteps, "undo");
  }

  /** Redoes the change that was undone last. */
  void redo() {
    step(redoSteps, undoSteps, "redo");
  }

  private void step(Deque<Scenario> from, Deque<Scenario> to, String action) {
    if (from.isEmpty()) {
      throw new InputException("there is no change to " + action);
    }
    to.push(current);
    current = from.pop();
    lastMoved = "";
  }

  /** Moves a camera to a place in the field that is not in a solid obstacle. */
  void move(String name, double x, double y) {
    checkPlace(x, y);
    change(name, camera -> camera.with(CameraSpec.X, x).with(CameraSpec.Y, y));
  }

  /** Turns a camera to a heading in degrees. */
  void turn(String name, double heading) {
    if (!Double.isFinite(heading)) {
      throw new InputException("heading is %s, expected degrees".formatted(heading));
    }
    change(name, camera -> camera.with(CameraSpec.HEADING, heading));
  }

  private void change(String name, UnaryOperator<CameraSpec> change) {
    apply(
        name,
        current.withCameras(camera -> camera.name().equals(name) ? change.apply(camera) : camera));
  }

  /** Adds a copy of a camera at another place, after the cameras of the start. */
  void addCopy(String original, double x, double y) {
    checkPlace(x, y);
    CameraSpec added =
        camera(original)
            .orElseThrow()
            .with(CameraSpec.NAME, freeName())
            .with(CameraSpec.X, x)
            .with(CameraSpec.Y, y);
    addCamera(added);
  }

  /** Adds a camera under a free name, at a place in the field that is not in an obstacle. */
  void add(CameraSpec camera) {
    checkPlace(camera.x(), camera.y());
    addCamera(camera.with(CameraSpec.NAME, freeName()));
  }

  private void addCamera(CameraSpec camera) {
    List<CameraSpec> cameras = new ArrayList<>(current.cameras());
    cameras.add(camera);
    apply("", current.with(Scenario.CAMERAS, cameras));
  }

  /** Replaces the camera of the same name. */
  void replace(CameraSpec replacement) {
    apply(
        "",
        current.withCameras(
            camera -> camera.name().equals(replacement.name()) ? replacement : camera));
  }

  /** Removes a camera and its events. */
  void removeCamera(int number) {
    String name = element(current.everyCamera().toList(), number, "camera").name();
    Scenario rest = without(Scenario.CAMERAS, number, ScenarioEvent.AddCamera.class);
    List<ScenarioEvent> events =
        rest.events().stream()
            .filter(event -> !event.existingCamera().equals(Optional.of(name)))
            .toList();
    apply("", rest.with(Scenario.EVENTS, events));
  }

  /** Removes a target. */
  void removeTarget(int number) {
    element(current.everyTarget().toList(), number, "target");
    apply("", without(Scenario.TARGETS, number, ScenarioEvent.AddTarget.class));
  }

  /** Adds a solid obstacle, which must hit no camera and no target, after the others. */
  void addObstacle(DrawnObstacle shape, Point from, Point to, Double height) {
    checkInField(from.x(), from.y());
    checkInField(to.x(), to.y());
    Obstacle drawn = shape.obstacle(from, to, height);
    freePlaces()
        .filter(place -> drawn.contains(place.x(), place.y()))
        .findFirst()
        .ifPresent(
            place -> {
              throw InputException.of(
                  "the %s hits a camera or a target at (%s, %s), expected one away from all of"
                      + " them",
                  Spelling.of(shape), place.x(), place.y());
            });
    List<Obstacle> obstacles = new ArrayList<>(current.obstacles());
    obstacles.add(drawn);
    apply("", current.with(Scenario.OBSTACLES, obstacles));
  }

  /** Adds a zone, under a free name if it has none. */
  void addZone(Zone zone) {
    Zone named = zone.name().isBlank() ? zone.named(freeZoneName()) : zone;
    if (hasZone(named.name())) {
      throw InputException.of("name is '%s', expected one that no other zone has", named.name());
    }
    if (named.maxDepression() != null && !current.hasHeights()) {
      throw InputException.of(
          "%s is %s, expected %s", Zone.MAX_DEPRESSION, named.maxDepression(), Zone.NO_DEPRESSION);
    }
    named.points().forEach(point -> checkInField(point.x(), point.y()));
    List<Zone> zones = new ArrayList<>(current.zones());
    zones.add(named);
    apply("", current.with(Scenario.ZONES, zones));
  }

  private String freeZoneName() {
    int number = 1;
    while (hasZone(ZONE_PREFIX + number)) {
      number++;
    }
    return ZONE_PREFIX + number;
  }

  private boolean hasZone(String name) {
    return current.zones().stream().anyMatch(zone -> zone.name().equals(name));
  }

  /** Removes a zone. */
  void removeZone(int number) {
    element(current.zones(), number, "zone");
    apply("", current.with(Scenario.ZONES, without(current.zones(), number)));
  }

  /** Scales a site without targets, so that a line drawn on it has this length, in metres. */
  void scale(Point from, Point to, double metres) {
    double drawn = Math.hypot(to.x() - from.x(), to.y() - from.y());
    apply("", new ScaledSite(metres / drawn).of(current));
  }

  /**
   * Hangs all cameras at another height, in metres.
   *
   * @throws InputException if the scenario gives no height of all cameras, or this one is wrong
   */
  void hangAt(double metres) {
    if (current.mountHeight().isEmpty()) {
      throw InputException.of("the scenario has no %s, expected one", Scenario.MOUNT_HEIGHT);
    }
    if (!Range.POSITIVE_LENGTH.contains(metres)) {
      throw InputException.of(
          "%s is %s, expected %s", Scenario.MOUNT_HEIGHT, metres, Range.POSITIVE_LENGTH.expected());
    }
    apply(
        "",
        current
            .with(Scenario.MOUNT_HEIGHT, metres)
            .withCameras(camera -> camera.without(CameraSpec.Z)));
  }

  /**
   * Takes cameras that were planned for a site.
   *
   * @throws InputException if the site has changed, apart from its cameras
   */
  void usePlan(Scenario site, List<CameraSpec> cameras) {
    if (!withoutCameras(site).equals(withoutCameras(current))) {
      throw new InputException("the site has changed since, expected to plan again");
    }
    apply("", current.with(Scenario.CAMERAS, cameras));
  }

  private static Scenario withoutCameras(Scenario site) {
    return site.with(Scenario.CAMERAS, List.of());
  }

  /** Removes an obstacle. */
  void removeObstacle(int number) {
    element(current.obstacles(), number, "obstacle");
    apply("", current.with(Scenario.OBSTACLES, without(current.obstacles(), number)));
  }

  private static <T> T element(List<T> elements, int number, String name) {
    if (number < 0 || number >= elements.size()) {
      throw InputException.of(
          "%s is %s, expected one of the %s, from 0", name, number, elements.size());
    }
    return elements.get(number);
  }

  /**
   * Returns the scenario without an element, or without the event that adds it.
   *
   * @param number the number of the element; those of the start come first, then those that events
   *     add
   * @param addition the events that add such elements
   */
  private <T> Scenario without(
      Property<Scenario, List<T>> list, int number, Class<? extends ScenarioEvent> addition) {
    List<T> start = current.get(list);
    if (number < start.size()) {
      return current.with(list, without(start, number));
    }
    ScenarioEvent event =
        current.events().stream().filter(addition::isInstance).toList().get(number - start.size());
    List<ScenarioEvent> events = current.events();
    return current.with(Scenario.EVENTS, without(events, events.indexOf(event)));
  }

  private static <T> List<T> without(List<T> list, int number) {
    List<T> rest = new ArrayList<>(list);
    rest.remove(number);
    return rest;
  }

  /** The names of targets whose waypoints lead them through a solid obstacle. */
  List<String> blockedTargets() {
    Obstacles solid = new Obstacles(current.obstacles());
    return current
        .everyTarget()
        .filter(target -> isBlocked(target.waypoints(), solid))
        .map(TargetSpec::name)
        .toList();
  }

  private static boolean isBlocked(List<Waypoint> waypoints, Obstacles obstacles) {
    return IntStream.range(0, waypoints.size())
        .anyMatch(
            i -> {
              Waypoint from = waypoints.get(i);
              Waypoint to = waypoints.get((i + 1) % waypoints.size());
              return obstacles.transmittance(from.x(), from.y(), to.x(), to.y()) == 0;
            });
  }

  /** The places that must not be in anything solid: those of cameras, targets and waypoints. */
  private Stream<Point> freePlaces() {
    return Stream.concat(
        current.everyCamera().map(camera -> new Point(camera.x(), camera.y())),
        current.everyTarget().flatMap(EditedScenario::places));
  }

  private static Stream<Point> places(TargetSpec target) {
    return Stream.concat(
        Stream.of(new Point(target.x(), target.y())),
        target.waypoints().stream().map(waypoint -> new Point(waypoint.x(), waypoint.y())));
  }

  private String freeName() {
    int number = 1;
    while (camera(ADDED_PREFIX + number).isPresent()) {
      number++;
    }
    return ADDED_PREFIX + number;
  }

  /** The camera of this name, if there is one. */
  Optional<CameraSpec> camera(String name) {
    return current.everyCamera().filter(camera -> camera.name().equals(name)).findFirst();
  }

  private void checkPlace(double x, double y) {
    checkInField(x, y);
    if (new Obstacles(current.obstacles()).containing(x, y).isPresent()) {
      throw InputException.of(
          "x is %s and y is %s, expected a place outside all solid obstacles", x, y);
    }
  }

  private void checkInField(double x, double y) {
    Field field = current.field();
    if (!field.contains(x, y) || Double.isNaN(x) || Double.isNaN(y)) {
      throw InputException.of("x is %s and y is %s, expected a place in the field", x, y);
    }
  }
}
