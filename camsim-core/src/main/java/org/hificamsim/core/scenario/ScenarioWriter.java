package org.hificamsim.core.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * Writes scenarios as XML that {@link ScenarioReader} reads back as an equal scenario; comments and
 * layout of an original file are not kept.
 */
public final class ScenarioWriter {
  private final XmlWriter xml = new XmlWriter();
  private final Optional<String> tracksFile;

  private ScenarioWriter(Optional<String> tracksFile) {
    this.tracksFile = tracksFile;
  }

  /** The scenario as an XML document. */
  public static String write(Scenario scenario) {
    return new ScenarioWriter(Optional.empty()).document(scenario);
  }

  /**
   * The scenario as an XML document that names a file of tracks beside it.
   *
   * @param scenario without tracks of its own
   * @param tracks the file's path from the scenario's folder
   */
  public static String write(Scenario scenario, String tracks) {
    return new ScenarioWriter(Optional.of(tracks)).document(scenario);
  }

  private String document(Scenario scenario) {
    scenario(scenario);
    return xml.document();
  }

  private void scenario(Scenario scenario) {
    Map<String, Object> attributes = new LinkedHashMap<>();
    attributes.put("min_x", scenario.field().minX());
    attributes.put("max_x", scenario.field().maxX());
    attributes.put("min_y", scenario.field().minY());
    attributes.put("max_y", scenario.field().maxY());
    attributes.put("order", Spelling.of(scenario.order()));
    attributes.put("headings", Spelling.of(scenario.headings()));
    scenario.threshold().ifPresent(value -> attributes.put("threshold", value));
    scenario.detect().ifPresent(rule -> attributes.put("detect", rule.text()));
    if (!scenario.objective().equals(Objective.kMin())) {
      attributes.put("objective", scenario.objective().text());
    }
    scenario.mountHeight().ifPresent(value -> attributes.put("mount_height", value));
    if (scenario.stepTime() != 1) {
      attributes.put("step", scenario.stepTime());
    }
    surroundings(attributes, scenario.surroundings());
    attributes.putAll(new TreeMap<>(scenario.extras()));
    xml.open("root", Map.of());
    xml.open("simulation", attributes);
    obstacles(scenario.surroundings().obstacles());
    xml.open("cameras", Map.of());
    scenario
        .everyCamera()
        .flatMap(camera -> camera.optics().stream())
        .distinct()
        .forEach(optics -> xml.empty("optics", optics(optics)));
    if (!scenario.zooms().isEmpty()) {
      xml.text("zoom", listed(scenario.zooms().stream().map(String::valueOf)));
    }
    for (CameraSpec camera : scenario.cameras()) {
      xml.empty("camera", camera(camera));
    }
    xml.close();
    xml.open("objects", Map.of());
    for (TargetSpec target : scenario.targets()) {
      target(target);
    }
    TrackedTargets tracked = TrackedTargets.of(scenario.events());
    tracksFile.ifPresent(file -> xml.empty("tracks", Map.of("file", file)));
    if (!tracked.additions().isEmpty()) {
      xml.lines("tracks", tracked::write); // in the element itself: the text is all of the scenario
    }
    xml.close();
    events(tracked.others(scenario.events()));
    if (scenario.visionGraph().isPresent()) {
      visionGraph(scenario.visionGraph().get());
    }
    xml.close();
    xml.close();
  }

  private static void surroundings(Map<String, Object> attributes, Surroundings surroundings) {
    if (surroundings.occlusion() != Occlusion.NONE) {
      attributes.put("occlusion", Spelling.of(surroundings.occlusion()));
    }
    surroundings
        .floorplan()
        .ifPresent(
            floorplan -> {
              attributes.put("floorplan", floorplan.file());
              attributes.put("floorplan_min_x", floorplan.area().minX());
              attributes.put("floorplan_max_x", floorplan.area().maxX());
              attributes.put("floorplan_min_y", floorplan.area().minY());
              attributes.put("floorplan_max_y", floorplan.area().maxY());
            });
  }

  private void obstacles(List<Obstacle> obstacles) {
    if (obstacles.isEmpty()) {
      return;
    }
    xml.open("obstacles", Map.of());
    obstacles.forEach(this::obstacle);
    xml.close();
  }

  private void obstacle(Obstacle obstacle) {
    Map<String, Object> attributes = new LinkedHashMap<>();
    String name = "polygon";
    if (obstacle instanceof Obstacle.Wall wall) {
      name = "wall";
      attributes.put("x1", wall.x1());
      attributes.put("y1", wall.y1());
      attributes.put("x2", wall.x2());
      attributes.put("y2", wall.y2());
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      name = "pillar";
      attributes.put("x", pillar.x());
      attributes.put("y", pillar.y());
      attributes.put("radius", pillar.radius());
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      attributes.put(
          "points", listed(polygon.points().stream().map(point -> point.x() + "," + point.y())));
    }
    if (obstacle.transmittance() != 0) {
      attributes.put("transmittance", obstacle.transmittance());
    }
    xml.empty(name, attributes);
  }

  private static Map<String, Object> optics(OpticsSpec optics) {
    Map<String, Object> attributes = new LinkedHashMap<>();
    attributes.put("name", optics.name());
    attributes.put("law", Spelling.of(optics.law()));
    optics.pixels().ifPresent(value -> attributes.put("pixels", value));
    if (!optics.anglesOfView().isEmpty()) {
      attributes.put("hfov", listed(optics.anglesOfView().stream().map(String::valueOf)));
    }
    optics.reach().ifPresent(value -> attributes.put("reach", value));
    attributes.put("pan", listed(optics.pans().stream().map(String::valueOf)));
    optics.panSpeed().ifPresent(value -> attributes.put("pan_speed", value));
    attributes.put("zoom_time", optics.zoomTime());
    attributes.put("moving", Spelling.of(optics.moving()));
    return attributes;
  }

  private static String listed(Stream<String> items) {
    return items.collect(Collectors.joining(" "));
  }

  private static Map<String, Object> camera(CameraSpec camera) {
    Map<String, Object> attributes = new LinkedHashMap<>();
    attributes.put("name", camera.name());
    attributes.put("x", camera.x());
    attributes.put("y", camera.y());
    attributes.put("heading", camera.heading());
    attributes.put("viewing_angle", camera.viewingAngle());
    attributes.put("range", camera.range());
    camera.optics().ifPresent(optics -> attributes.put("optics", optics.name()));
    AgentSpec agent = camera.agent();
    agent.algorithm().ifPresent(value -> attributes.put("ai_algorithm", value));
    agent.comm().ifPresent(value -> attributes.put("comm", value));
    agent.customComm().ifPresent(value -> attributes.put("customcom", value));
    if (agent.limit() != 0) {
      attributes.put("limit", agent.limit());
    }
    agent.bandit().ifPresent(value -> attributes.put("bandit", value));
    attributes.putAll(new TreeMap<>(camera.extras()));
    return attributes;
  }

  private void target(TargetSpec target) {
    Map<String, Object> attributes = new LinkedHashMap<>();
    attributes.put("features", target.features());
    if (target.origin() == TargetSpec.Origin.OBJECT_WITH_WAYPOINTS) {
      attributes.put("speed", target.speed());
      size(target, attributes);
      attributes.putAll(new TreeMap<>(target.extras()));
      withWaypoints("object_with_waypoints", attributes, target.movement().waypoints());
      return;
    }
    attributes.put("move", target.movement().name());
    motion(target, attributes);
    withWaypoints("object", attributes, target.movement().waypoints());
  }

  private static void size(TargetSpec target, Map<String, Object> attributes) {
    if (target.extent().isEmpty()) {
      attributes.put("size", target.size());
    }
    target
        .extent()
        .ifPresent(
            extent -> {
              attributes.put("width", extent.width());
              attributes.put("height", extent.height());
            });
  }

  private static void motion(TargetSpec target, Map<String, Object> attributes) {
    attributes.put("x", target.x());
    attributes.put("y", target.y());
    attributes.put("heading", target.heading());
    attributes.put("speed", target.speed());
    size(target, attributes);
    attributes.put("mean", target.movement().mean());
    attributes.put("std", target.movement().std());
    attributes.putAll(new TreeMap<>(target.extras()));
  }

  private void events(List<ScenarioEvent> events) {
    if (events.isEmpty()) {
      return;
    }
    xml.open("events", Map.of());
    for (ScenarioEvent event : events) {
      Map<String, Object> attributes = new LinkedHashMap<>();
      attributes.put("timestep", event.step());
      describe(event, attributes);
      withWaypoints(
          "event",
          attributes,
          event instanceof ScenarioEvent.AddTarget add
              ? add.target().movement().waypoints()
              : List.of());
    }
    xml.close();
  }

  private static void describe(ScenarioEvent event, Map<String, Object> attributes) {
    if (event instanceof ScenarioEvent.AddCamera add) {
      kind(attributes, "camera", "add");
      attributes.putAll(camera(add.camera()));
    } else if (event instanceof ScenarioEvent.ChangeCamera change) {
      kind(attributes, "camera", "change");
      change(attributes, change);
    } else if (event instanceof ScenarioEvent.FailCamera fail) {
      kind(attributes, "camera", "error");
      attributes.put("name", fail.camera());
      attributes.put("duration", fail.duration());
    } else if (event instanceof ScenarioEvent.AddTarget add) {
      kind(attributes, "object", "add");
      add(attributes, add.target());
    } else if (event instanceof ScenarioEvent.RemoveTarget remove) {
      kind(attributes, "object", "error");
      attributes.put("name", remove.features());
    } else if (event instanceof ScenarioEvent.FailRegistration fail) {
      kind(attributes, "grc", "error");
      attributes.put("duration", fail.duration());
    }
  }

  private static void add(Map<String, Object> attributes, TargetSpec target) {
    attributes.put("name", target.features());
    if (!target.movement().name().isEmpty()) {
      attributes.put("fqName", target.movement().name());
    }
    motion(target, attributes);
  }

  private static void kind(Map<String, Object> attributes, String participant, String event) {
    attributes.put("participant", participant);
    attributes.put("event", event);
  }

  private static void change(Map<String, Object> attributes, ScenarioEvent.ChangeCamera change) {
    attributes.put("name", change.camera());
    attributes.put("x", change.x());
    attributes.put("y", change.y());
    attributes.put("heading", change.heading());
    attributes.put("viewing_angle", change.viewingAngle());
    attributes.put("range", change.range());
  }

  private void visionGraph(VisionGraph graph) {
    xml.open("visiongraph", Map.of("static", graph.isStatic()));
    for (Map.Entry<String, List<String>> node : graph.neighbours().entrySet()) {
      xml.open("graphnode", Map.of("name", node.getKey()));
      for (String neighbour : node.getValue()) {
        xml.empty("neighbour", Map.of("name", neighbour));
      }
      xml.close();
    }
    xml.close();
  }

  private void withWaypoints(
      String name, Map<String, Object> attributes, List<Waypoint> waypoints) {
    if (waypoints.isEmpty()) {
      xml.empty(name, attributes);
      return;
    }
    xml.open(name, attributes);
    for (Waypoint waypoint : waypoints) {
      Map<String, Object> place = new LinkedHashMap<>();
      place.put("x", waypoint.x());
      place.put("y", waypoint.y());
      xml.empty("waypoint", place);
    }
    xml.close();
  }
}
