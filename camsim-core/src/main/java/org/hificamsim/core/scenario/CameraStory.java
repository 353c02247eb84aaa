package org.hificamsim.core.scenario;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** Where cameras stand, and which are online, as one event after the other happens. */
final class CameraStory {
  private final CameraReader cameras;
  private final Consumer<String> warnings;
  private final Map<String, Waypoint> positions = new HashMap<>();
  private final Set<String> failed = new HashSet<>();

  CameraStory(List<CameraSpec> start, CameraReader cameras, Consumer<String> warnings) {
    this.cameras = cameras;
    this.warnings = warnings;
    start.forEach(this::add);
  }

  private void add(CameraSpec camera) {
    positions.put(camera.name(), new Waypoint(camera.x(), camera.y()));
  }

  /**
   * The next event, in the order of time.
   *
   * @throws org.hificamsim.core.InputException when it is of a camera that never comes, or puts one
   *     into an obstacle
   */
  void goOn(ScenarioEvent event, XmlElement element) {
    if (event instanceof ScenarioEvent.AddCamera add) {
      add(add.camera());
    } else if (event instanceof ScenarioEvent.ChangeCamera change) {
      check(element, change.camera(), change.step());
      positions.computeIfPresent(
          change.camera(), (name, before) -> cameras.moved(element, change, before));
    } else if (event instanceof ScenarioEvent.FailCamera fail) {
      check(element, fail.camera(), fail.step());
      if (fail.duration() != 0) {
        failed.add(fail.camera());
      }
    }
  }

  private void check(XmlElement element, String camera, int step) {
    if (!cameras.knows(camera)) {
      throw new Attributes(element).invalid("name", "the name of a camera");
    }
    if (!positions.containsKey(camera) || failed.contains(camera)) {
      warnings.accept(
          element
              .place("name")
              .line(
                  "camera '%s' is not online at step %s, nothing happens"
                      .formatted(camera, step)));
    }
  }
}
