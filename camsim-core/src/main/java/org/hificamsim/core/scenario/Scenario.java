package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;

/**
 * A scenario: the field, the cameras, the targets, and what happens when.
 *
 * @param name the file's name without its ending
 * @param order when targets move within a step
 * @param headings the unit of the targets' headings
 * @param threshold detection threshold, if the file sets one
 * @param detect how a confidence becomes a detection, if the file says so
 * @param objective what a step is scored by
 * @param mountHeight height of all cameras over the target plane, metres (Eq 3.2), if given
 * @param stepTime how long a step takes, seconds, above 0; 1 unless the file says otherwise
 * @param surroundings obstacles and what else stands in the field
 * @param zooms candidate radii common to all cameras, metres, rising; empty for a plain CamSim
 *     scenario, where each camera has its range alone
 * @param cameras those of the start, in file order, with unique names
 * @param targets those of the start: objects, then objects with waypoints, in file order
 * @param events in file order
 * @param visionGraph the initial links, if given
 * @param extras attributes of {@code simulation} that nothing here reads, kept for the writer
 */
public record Scenario(
    String name,
    Field field,
    StepOrder order,
    Headings headings,
    OptionalDouble threshold,
    Optional<DetectionRule> detect,
    Objective objective,
    OptionalDouble mountHeight,
    double stepTime,
    Surroundings surroundings,
    List<Double> zooms,
    List<CameraSpec> cameras,
    List<TargetSpec> targets,
    List<ScenarioEvent> events,
    Optional<VisionGraph> visionGraph,
    Map<String, String> extras) {
  /** Copies what could change. */
  public Scenario {
    zooms = List.copyOf(zooms);
    cameras = List.copyOf(cameras);
    targets = List.copyOf(targets);
    events = List.copyOf(events);
    extras = Map.copyOf(extras);
  }

  /** A scenario in an open field, whose steps take a second. */
  public Scenario(
      String name,
      Field field,
      StepOrder order,
      Headings headings,
      OptionalDouble threshold,
      Optional<DetectionRule> detect,
      Objective objective,
      OptionalDouble mountHeight,
      List<Double> zooms,
      List<CameraSpec> cameras,
      List<TargetSpec> targets,
      List<ScenarioEvent> events,
      Optional<VisionGraph> visionGraph,
      Map<String, String> extras) {
    this(
        name,
        field,
        order,
        headings,
        threshold,
        detect,
        objective,
        mountHeight,
        1,
        Surroundings.NONE,
        zooms,
        cameras,
        targets,
        events,
        visionGraph,
        extras);
  }

  /** Whether the file is in the coverage study's dialect, recognised by its zoom list. */
  public boolean inCoverageDialect() {
    return !zooms.isEmpty();
  }

  /** The cameras of the start, and those that events add. */
  public Stream<CameraSpec> everyCamera() {
    return Stream.concat(
        cameras.stream(),
        events.stream()
            .filter(ScenarioEvent.AddCamera.class::isInstance)
            .map(event -> ((ScenarioEvent.AddCamera) event).camera()));
  }

  /** The same scenario with targets moving at another time within the step. */
  public Scenario withOrder(StepOrder newOrder) {
    return changed(draft -> draft.order = newOrder);
  }

  /** The same scenario with another rule of detection; its threshold goes with the old one. */
  public Scenario withDetect(DetectionRule rule) {
    return changed(
        draft -> {
          draft.detect = Optional.of(rule);
          draft.threshold = rule.certain() ? threshold : OptionalDouble.empty();
        });
  }

  /** The same scenario, its steps scored by another objective. */
  public Scenario withObjective(Objective newObjective) {
    return changed(draft -> draft.objective = newObjective);
  }

  /** The same scenario with another reading of the targets' headings. */
  public Scenario withHeadings(Headings newHeadings) {
    return changed(draft -> draft.headings = newHeadings);
  }

  /**
   * The same scenario under another name with its cameras at another height.
   *
   * @param height metres, above 0
   */
  public Scenario withMountHeight(String newName, double height) {
    return changed(
        draft -> {
          draft.name = newName;
          draft.mountHeight = OptionalDouble.of(height);
        });
  }

  /** The same world under another name with other targets and events. */
  public Scenario with(String newName, List<TargetSpec> newTargets, List<ScenarioEvent> newEvents) {
    return changed(
        draft -> {
          draft.name = newName;
          draft.targets = newTargets;
          draft.events = newEvents;
        });
  }

  /** The same scenario without its zoom list: each camera has its range alone, as in CamSim. */
  public Scenario withoutZooms() {
    return withZooms(List.of());
  }

  /** The same scenario with other radii common to all cameras, metres, rising. */
  public Scenario withZooms(List<Double> radii) {
    return changed(draft -> draft.zooms = radii);
  }

  /** The same scenario with every target, now or later, under one movement. */
  public Scenario withMovement(String movement) {
    return withTargets(target -> target.withMovement(movement));
  }

  /** The same scenario with other obstacles, occlusion or floorplan. */
  public Scenario withSurroundings(Surroundings newSurroundings) {
    return changed(draft -> draft.surroundings = newSurroundings);
  }

  /** The same scenario with one camera more, after those of the start. */
  public Scenario withCamera(CameraSpec added) {
    return changed(
        draft -> draft.cameras = Stream.concat(cameras.stream(), Stream.of(added)).toList());
  }

  /** The same scenario with every camera, now or later, changed. */
  public Scenario withCameras(UnaryOperator<CameraSpec> change) {
    return changed(
        draft -> {
          draft.cameras = cameras.stream().map(change).toList();
          draft.events = events.stream().map(event -> withCamera(event, change)).toList();
        });
  }

  /** The same scenario with every target, now or later, changed. */
  public Scenario withTargets(UnaryOperator<TargetSpec> change) {
    return with(
        name,
        targets.stream().map(change).toList(),
        events.stream().map(event -> withTarget(event, change)).toList());
  }

  private Scenario changed(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.scenario(this);
  }

  /** What a change may set; it begins as the scenario is. */
  private static final class Draft {
    private String name;
    private StepOrder order;
    private Headings headings;
    private OptionalDouble threshold;
    private Optional<DetectionRule> detect;
    private Objective objective;
    private OptionalDouble mountHeight;
    private Surroundings surroundings;
    private List<Double> zooms;
    private List<CameraSpec> cameras;
    private List<TargetSpec> targets;
    private List<ScenarioEvent> events;

    Draft(Scenario of) {
      name = of.name;
      order = of.order;
      headings = of.headings;
      threshold = of.threshold;
      detect = of.detect;
      objective = of.objective;
      mountHeight = of.mountHeight;
      surroundings = of.surroundings;
      zooms = of.zooms;
      cameras = of.cameras;
      targets = of.targets;
      events = of.events;
    }

    Scenario scenario(Scenario of) {
      return new Scenario(
          name,
          of.field,
          order,
          headings,
          threshold,
          detect,
          objective,
          mountHeight,
          of.stepTime,
          surroundings,
          zooms,
          cameras,
          targets,
          events,
          of.visionGraph,
          of.extras);
    }
  }

  private static ScenarioEvent withCamera(ScenarioEvent event, UnaryOperator<CameraSpec> change) {
    return event instanceof ScenarioEvent.AddCamera add
        ? new ScenarioEvent.AddCamera(add.step(), change.apply(add.camera()))
        : event;
  }

  private static ScenarioEvent withTarget(ScenarioEvent event, UnaryOperator<TargetSpec> change) {
    return event instanceof ScenarioEvent.AddTarget add
        ? new ScenarioEvent.AddTarget(add.step(), change.apply(add.target()))
        : event;
  }
}
