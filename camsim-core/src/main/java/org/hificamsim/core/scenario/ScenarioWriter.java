package org.hificamsim.core.scenario;

import static java.util.stream.Collectors.joining;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * Writes scenarios as XML that {@link ScenarioReader} reads back as an equal scenario; comments and
 * layout of an original file are not kept.
 */
public final class ScenarioWriter {
  private final XmlWriter xml = new XmlWriter();
  private final Scenario scenario;
  private final TrackedTargets tracked;
  private final Optional<String> tracksFile;

  private ScenarioWriter(Scenario scenario, Optional<String> tracksFile) {
    this.scenario = scenario;
    this.tracked = TrackedTargets.of(scenario.events());
    this.tracksFile = tracksFile;
  }

  /** The scenario as an XML document. */
  public static String write(Scenario scenario) {
    return new ScenarioWriter(scenario, Optional.empty()).document();
  }

  /**
   * The scenario as an XML document that names a file of tracks next to it.
   *
   * @param scenario without tracks of its own
   * @param tracks the file's path from the scenario's folder
   */
  public static String write(Scenario scenario, String tracks) {
    return new ScenarioWriter(scenario, Optional.of(tracks)).document();
  }

  private String document() {
    xml.element(
        Scenario.ROOT.name(),
        Map.of(),
        () ->
            xml.element(
                Scenario.ELEMENT.name(), Scenario.ELEMENT.written(scenario), this::simulation));
    return xml.document();
  }

  private void simulation() {
    if (!scenario.obstacles().isEmpty()) {
      xml.element(
          Scenario.OBSTACLES_HOLDER.name(),
          Map.of(),
          () -> scenario.obstacles().forEach(this::obstacle));
    }
    xml.element(Scenario.CAMERAS_HOLDER.name(), Map.of(), this::cameras);
    xml.element(Scenario.TARGETS_HOLDER.name(), Map.of(), this::targets);
    List<ScenarioEvent> events = tracked.others(scenario.events());
    if (!events.isEmpty()) {
      xml.element(Scenario.EVENTS_HOLDER.name(), Map.of(), () -> events.forEach(this::event));
    }
    scenario.visionGraph().ifPresent(this::visionGraph);
  }

  private void obstacle(Obstacle obstacle) {
    ObstacleElements.ALL.stream()
        .filter(element -> element.type().isInstance(obstacle))
        .forEach(element -> member(element, obstacle));
  }

  private <S> void member(Element<S> element, Object one) {
    element(element, element.said(element.type().cast(one)));
  }

  private void cameras() {
    scenario
        .everyCamera()
        .flatMap(camera -> camera.optics().stream())
        .distinct()
        .forEach(optics -> element(OpticsSpec.ELEMENT, optics));
    if (!scenario.zooms().isEmpty()) {
      String radii = scenario.zooms().stream().map(String::valueOf).collect(joining(" "));
      xml.text(ZoomListReader.ELEMENT.name(), radii);
    }
    scenario.cameras().forEach(camera -> element(CameraSpec.ELEMENT, camera));
  }

  private void targets() {
    for (TargetSpec target : scenario.targets()) {
      boolean plain = target.origin() != TargetSpec.Origin.OBJECT_WITH_WAYPOINTS;
      Element<TargetSpec> element = plain ? TargetSpec.ELEMENT : TargetSpec.WITH_WAYPOINTS;
      withWaypoints(element.name(), element.written(target), target.waypoints());
    }
    tracksFile.ifPresent(
        file -> xml.element(TracksReader.ELEMENT.name(), Map.of(TracksReader.FILE.name(), file)));
    if (!tracked.additions().isEmpty()) { // as text: what is written is all of the scenario
      xml.lines(TracksReader.ELEMENT.name(), tracked::write);
    }
  }

  private void event(ScenarioEvent event) {
    EventKind<?, ?> kind =
        ScenarioEvent.kinds().stream()
            .filter(one -> one.type().isInstance(event))
            .findFirst()
            .orElseThrow();
    List<Waypoint> path =
        event instanceof ScenarioEvent.AddTarget add ? add.target().waypoints() : List.of();
    withWaypoints(EventReader.ELEMENT.name(), kind.written(event), path);
  }

  private void visionGraph(VisionGraph graph) {
    xml.element(
        "visiongraph",
        Map.of("static", String.valueOf(graph.isStatic())),
        () -> graph.neighbours().forEach(this::node));
  }

  private void node(String camera, List<String> neighbours) {
    Runnable all = () -> neighbours.forEach(one -> xml.element("neighbour", Map.of("name", one)));
    xml.element("graphnode", Map.of("name", camera), all);
  }

  private void withWaypoints(String name, Map<String, String> attributes, List<Waypoint> path) {
    if (path.isEmpty()) {
      xml.element(name, attributes);
    } else {
      xml.element(name, attributes, () -> path.forEach(corner -> member(Waypoint.ELEMENT, corner)));
    }
  }

  private <S> void element(Element<S> element, Spec<S> spec) {
    xml.element(element.name(), element.written(spec));
  }
}
