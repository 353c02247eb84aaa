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

/** Checks that events fit each other: who is added, changed and removed, and when. */
public final class EventStory {
  private static final int FOR_EVER = -1;

  private final List<Told> events;
  private final Clearing clearing;
  private final Set<String> names = new HashSet<>(); // of cameras that are ever there
  private final Map<String, Waypoint> positions = new HashMap<>(); // of cameras that are there now
  private final Set<String> failed = new HashSet<>();
  private final Set<Double> features = new HashSet<>(); // of targets that are there now

  /** An event and the element that brings it. */
  public record Told(ScenarioEvent event, XmlElement xml) {
    boolean isOfTracks() {
      return xml.name().equals(TracksReader.ELEMENT.name());
    }
  }

  /**
   * @param cameras those of the start
   * @param targets those of the start
   */
  public EventStory(
      List<Told> events, List<CameraSpec> cameras, List<TargetSpec> targets, Clearing clearing) {
    this.events = events.stream().sorted(Comparator.comparingInt(one -> one.event.step())).toList();
    this.clearing = clearing;
    cameras.forEach(this::add);
    targets.forEach(target -> features.add(target.features()));
    for (Told one : events) {
      if (one.event instanceof AddCamera add) {
        names.add(add.camera().name());
      }
    }
  }

  private void add(CameraSpec camera) {
    names.add(camera.name());
    positions.put(camera.name(), new Waypoint(camera.x(), camera.y()));
  }

  /** Goes through it in the order of time. */
  public void check(Faults faults) {
    events.forEach(one -> faults.check(() -> followTarget(one)));
    events.forEach(one -> faults.check(() -> followCamera(one)));
  }

  private void followTarget(Told one) {
    if (one.event instanceof AddTarget add && !features.add(add.target().features())) {
      String expected = "features that no object present has";
      throw one.isOfTracks()
          ? one.xml
              .place()
              .error(
                  "target %s of the tracks comes at step %s while another one is there, expected"
                      + " %s",
                  add.target().name(), add.step(), expected)
          : one.xml.invalid("name", expected);
    }
    if (one.event instanceof RemoveTarget remove
        && !features.remove(remove.features())
        && !one.isOfTracks()) {
      one.xml.warn(
          "name",
          "no object %s is there at step %s, nothing is removed"
              .formatted(remove.features(), remove.step()));
    }
  }

  private void followCamera(Told one) {
    one.event.existingCamera().ifPresent(camera -> requireOnline(one, camera));
    if (one.event instanceof AddCamera add) {
      add(add.camera());
    } else if (one.event instanceof ChangeCamera change) {
      positions.computeIfPresent(change.camera(), (name, from) -> moved(one.xml, change, from));
    } else if (one.event instanceof FailCamera fail) {
      fail(fail.camera(), fail.duration());
    }
  }

  /** A warning where a camera is not online; an error where it never is. */
  private void requireOnline(Told one, String camera) {
    if (!names.contains(camera)) {
      throw one.xml.invalid("name", Type.CAMERA.expected());
    }
    if (!positions.containsKey(camera) || failed.contains(camera)) {
      String unless =
          positions.containsKey(camera) ? " (unless a quirk of CamSim lets it come back)" : "";
      one.xml.warn(
          "name",
          "camera '%s' is not online at step %s, nothing happens%s"
              .formatted(camera, one.event.step(), unless));
    }
  }

  private Waypoint moved(XmlElement xml, ChangeCamera change, Waypoint from) {
    double x = change.x() == -1 ? from.x() : change.x();
    double y = change.y() == -1 ? from.y() : change.y();
    clearing.requireFree(xml, x, y);
    return new Waypoint(x, y);
  }

  /** In CamSim for ever, too, where it is for some steps (quirk Q6). */
  private void fail(String camera, int duration) {
    if (duration == FOR_EVER && !failed.contains(camera)) {
      positions.remove(camera);
    } else if (duration != 0) {
      failed.add(camera);
    }
  }
}
