package org.hificamsim.core.scenario;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.file.TracksReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.spec.ObstacleElements;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.spec.Zone;

/** The elements of scenario files: those that only hold others, and the list of all. */
final class ScenarioElements {
  static final Element<Scenario> ROOT =
      Element.<Scenario>of("root", "A scenario.").holds("simulation");
  static final Element<Scenario> OBSTACLES_HOLDER =
      Element.<Scenario>of(
              "obstacles",
              "What hides targets from cameras; where `transmittance` is 0 no target walks (ours).")
          .holds(
              ObstacleElements.ALL.stream().map(Element::name).collect(joining(" | ", "(", ")*")));
  static final Element<Scenario> ZONES_HOLDER =
      Element.<Scenario>of("zones", "What is demanded of the cameras, and where (ours).")
          .holds("zone*");
  static final Element<Scenario> ZOOM_LIST =
      Element.<Scenario>of(
              "zoom", "The radii that every camera can choose from, between spaces, rising, m.")
          .holds("#" + Type.RADII.schema());
  static final Element<Scenario> CAMERAS_HOLDER =
      Element.<Scenario>of("cameras", "The cameras of the start.").holds("optics*, zoom?, camera*");
  static final Element<Scenario> TARGETS_HOLDER =
      Element.<Scenario>of("objects", "The targets of the start, and recorded ones.")
          .holds("(object | object_with_waypoints | tracks)*");
  static final Element<Scenario> EVENTS_HOLDER =
      Element.<Scenario>of("events", "What happens when.").holds("event*");

  private ScenarioElements() {}

  /** All elements of scenario files. */
  static List<Element<?>> all() {
    List<Element<?>> elements = new ArrayList<>(List.of(ROOT, Scenario.ELEMENT, OBSTACLES_HOLDER));
    elements.addAll(ObstacleElements.ALL);
    elements.addAll(
        List.of(
            ZONES_HOLDER,
            Zone.ELEMENT,
            CAMERAS_HOLDER,
            OpticsSpec.ELEMENT,
            ZOOM_LIST,
            CameraSpec.ELEMENT,
            TARGETS_HOLDER,
            TargetSpec.ELEMENT,
            TargetSpec.WITH_WAYPOINTS,
            Waypoint.ELEMENT,
            TracksReader.ELEMENT,
            EVENTS_HOLDER,
            EventHead.ELEMENT,
            VisionGraph.ELEMENT,
            VisionGraph.NODE,
            VisionGraph.NEIGHBOUR));
    return elements;
  }
}
