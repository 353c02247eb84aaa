package org.hificamsim.core.scenario;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.file.TrackWriter;
import org.hificamsim.core.scenario.file.TracksReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.spec.EventKind;
import org.hificamsim.core.scenario.spec.ObstacleElements;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.scenario.xml.XmlWriter;

/**
 * Writes scenarios as XML that {@link ScenarioReader} reads back as an equal scenario; comments and
 * layout of an original file are not kept.
 */
public final class ScenarioWriter {
  private static final double NANOS_PER_SECOND = 1e9;

  private final XmlWriter xml = new XmlWriter();
  private final Scenario scenario;

  /** The events that add targets with tracks, in order. */
  private final List<AddTarget> tracked;

  private final Optional<String> tracksFile;

  private ScenarioWriter(Scenario scenario, Optional<String> tracksFile) {
    this.scenario = scenario;
    this.tracked = scenario.events(AddTarget.class).filter(ScenarioWriter::isTracked).toList();
    this.tracksFile = tracksFile;
  }

  /** Returns a scenario as an XML document. */
  public static String write(Scenario scenario) {
    return new ScenarioWriter(scenario, Optional.empty()).document();
  }

  /**
   * Returns a scenario as an XML document that refers to a file of tracks.
   *
   * @param scenario a scenario without tracks
   * @param tracks the path of the file from the scenario's folder
   */
  public static String write(Scenario scenario, String tracks) {
    return new ScenarioWriter(scenario, Optional.of(tracks)).document();
  }

  private String document() {
    xml.element(
        ScenarioElements.ROOT.name(),
        Map.of(),
        () ->
            xml.element(
                Scenario.ELEMENT.name(), Scenario.ELEMENT.written(scenario), this::simulation));
    return xml.document();
  }

  private void simulation() {
    if (!scenario.obstacles().isEmpty()) {
      xml.element(
          ScenarioElements.OBSTACLES_HOLDER.name(),
          Map.of(),
          () -> scenario.obstacles().forEach(this::obstacle));
    }
    if (!scenario.zones().isEmpty()) {
      xml.element(
          ScenarioElements.ZONES_HOLDER.name(),
          Map.of(),
          () -> scenario.zones().forEach(zone -> member(Zone.ELEMENT, zone)));
    }
    xml.element(ScenarioElements.CAMERAS_HOLDER.name(), Map.of(), this::cameras);
    xml.element(ScenarioElements.TARGETS_HOLDER.name(), Map.of(), this::targets);
    List<ScenarioEvent> events = eventsWithoutTracks();
    if (!events.isEmpty()) {
      xml.element(
          ScenarioElements.EVENTS_HOLDER.name(), Map.of(), () -> events.forEach(this::event));
    }
    scenario.visionGraph().ifPresent(this::visionGraph);
  }

  private void obstacle(Obstacle obstacle) {
    ObstacleElements.ALL.stream()
        .filter(element -> element.type().isInstance(obstacle))
        .forEach(element -> member(element, obstacle));
  }

  private <S> void member(Element<S> element, Object member) {
    element(element, element.specOf(element.type().cast(member)));
  }

  private void cameras() {
    scenario
        .everyCamera()
        .flatMap(camera -> camera.optics().stream())
        .distinct()
        .forEach(optics -> element(OpticsSpec.ELEMENT, optics));
    if (!scenario.zooms().isEmpty()) {
      xml.text(ScenarioElements.ZOOM_LIST.name(), Type.RADII.writer().apply(scenario.zooms()));
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
    // Tracks are written as text, so that one file has all of the scenario.
    if (!tracked.isEmpty()) {
      xml.lines(TracksReader.ELEMENT.name(), out -> Io.run(() -> tracks(out)));
    }
  }

  /** Events without those that add and remove targets with tracks, which the tracks stand for. */
  private List<ScenarioEvent> eventsWithoutTracks() {
    Set<ScenarioEvent> removals =
        tracked.stream()
            .map(add -> TracksReader.removal(track(add), add.target().features()))
            .collect(Collectors.toSet());
    return scenario.events().stream()
        .filter(event -> !(event instanceof AddTarget add && isTracked(add)))
        .filter(event -> !removals.contains(event))
        .toList();
  }

  private void tracks(Appendable out) throws IOException {
    TrackWriter writer = new TrackWriter(out, interval(track(tracked.get(0))), 0);
    for (AddTarget add : tracked) {
      TargetSpec target = add.target();
      if (target.extent().isPresent()) {
        writer.target(target.features(), target.extent().get());
      } else {
        writer.target(target.features(), target.size());
      }
      Track track = track(add);
      for (int i = 0; i < track.samples(); i++) {
        writer.sample(track.time(i), track.x(i), track.y(i));
      }
    }
  }

  /** The time between the first two samples of a track, rounded to nanoseconds. */
  private static double interval(Track track) {
    double interval = track.samples() == 1 ? 1 : track.time(1) - track.time(0);
    return Math.max(1, Math.rint(interval * NANOS_PER_SECOND)) / NANOS_PER_SECOND;
  }

  private static boolean isTracked(AddTarget add) {
    return add.target().track().isPresent();
  }

  private static Track track(AddTarget add) {
    return add.target().track().orElseThrow();
  }

  private void event(ScenarioEvent event) {
    EventKind<?, ?> kind =
        ScenarioEvent.kinds().stream()
            .filter(known -> known.type().isInstance(event))
            .findFirst()
            .orElseThrow();
    List<Waypoint> path = event instanceof AddTarget add ? add.target().waypoints() : List.of();
    withWaypoints(EventHead.ELEMENT.name(), kind.written(event), path);
  }

  private void visionGraph(VisionGraph graph) {
    xml.element(
        "visiongraph",
        Map.of("static", String.valueOf(graph.isStatic())),
        () -> graph.neighbours().forEach(this::node));
  }

  private void node(String camera, List<String> neighbours) {
    Runnable all = () -> neighbours.forEach(name -> xml.element("neighbour", Map.of("name", name)));
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
