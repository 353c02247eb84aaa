package org.hificamsim.core.scenario.file;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.RemoveTarget;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Checks that the events of a scenario fit together in the order of time. */
public final class EventSequence {
  private static final int FOR_EVER = -1;

  private final List<EventElement> events;
  private final ObstacleCheck obstacleCheck;

  /** The names of all cameras that are ever added. */
  private final Set<String> names = new HashSet<>();

  /** The positions of the present cameras by name. */
  private final Map<String, Waypoint> positions = new HashMap<>();

  private final Set<String> failed = new HashSet<>();

  /** The features of the present targets. */
  private final Set<Double> features = new HashSet<>();

  /** An event and the element that brings it. */
  public record EventElement(ScenarioEvent event, XmlElement xml) {
    boolean isOfTracks() {
      return xml.name().equals(TracksReader.ELEMENT.name());
    }
  }

  /**
   * @param cameras the cameras of the start
   * @param targets the targets of the start
   */
  public EventSequence(
      List<EventElement> events,
      List<CameraSpec> cameras,
      List<TargetSpec> targets,
      ObstacleCheck obstacleCheck) {
    this.events =
        events.stream().sorted(Comparator.comparingInt(element -> element.event.step())).toList();
    this.obstacleCheck = obstacleCheck;
    cameras.forEach(this::add);
    targets.forEach(target -> features.add(target.features()));
    for (EventElement element : events) {
      if (element.event instanceof AddCamera add) {
        names.add(add.camera().name());
      }
    }
  }

  private void add(CameraSpec camera) {
    names.add(camera.name());
    positions.put(camera.name(), new Waypoint(camera.x(), camera.y()));
  }

  /** Checks all events in the order of time. */
  public void check(Faults faults) {
    events.forEach(element -> faults.check(() -> followTarget(element)));
    events.forEach(element -> faults.check(() -> followCamera(element)));
  }

  private void followTarget(EventElement element) {
    if (element.event instanceof AddTarget add && !features.add(add.target().features())) {
      String expected = "features that no object present has";
      throw element.isOfTracks()
          ? element
              .xml
              .place()
              .error(
                  "target %s of the tracks comes at step %s while another one is there, expected"
                      + " %s",
                  add.target().name(), add.step(), expected)
          : element.xml.invalid("name", expected);
    }
    if (element.event instanceof RemoveTarget remove
        && !features.remove(remove.features())
        && !element.isOfTracks()) {
      element.xml.warn(
          "name",
          "no object %s is there at step %s, nothing is removed"
              .formatted(remove.features(), remove.step()));
    }
  }

  private void followCamera(EventElement element) {
    element.event.existingCamera().ifPresent(camera -> requireOnline(element, camera));
    if (element.event instanceof AddCamera add) {
      add(add.camera());
    } else if (element.event instanceof ChangeCamera change) {
      positions.computeIfPresent(change.camera(), (name, from) -> moved(element.xml, change, from));
    } else if (element.event instanceof FailCamera fail) {
      fail(fail.camera(), fail.duration());
    }
  }

  /** Warns if a camera is not online; refuses one that never is. */
  private void requireOnline(EventElement element, String camera) {
    if (!names.contains(camera)) {
      throw element.xml.invalid("name", Type.CAMERA.expected());
    }
    if (!positions.containsKey(camera) || failed.contains(camera)) {
      String unless =
          positions.containsKey(camera) ? " (unless a quirk of CamSim lets it come back)" : "";
      element.xml.warn(
          "name",
          "camera '%s' is not online at step %s, nothing happens%s"
              .formatted(camera, element.event.step(), unless));
    }
  }

  private Waypoint moved(XmlElement xml, ChangeCamera change, Waypoint from) {
    double x = change.x() == -1 ? from.x() : change.x();
    double y = change.y() == -1 ? from.y() : change.y();
    obstacleCheck.requireFree(xml, x, y);
    return new Waypoint(x, y);
  }

  /**
   * Notes that a camera fails permanently, even if a duration is given, as in CamSim (quirk Q6).
   */
  private void fail(String camera, int duration) {
    if (duration == FOR_EVER && !failed.contains(camera)) {
      positions.remove(camera);
    } else if (duration != 0) {
      failed.add(camera);
    }
  }
}
