package org.hificamsim.core.scenario;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** Where cameras stand, and which are online, as one event after the other happens. */
final class CameraStory {
  private static final int FOR_EVER = -1;

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
      fail(fail.camera(), fail.duration());
    }
  }

  /** In CamSim for ever, too, where it is for some steps (quirk Q6). */
  private void fail(String camera, int duration) {
    if (duration == FOR_EVER && !failed.contains(camera)) {
      positions.remove(camera);
    } else if (duration != 0) {
      failed.add(camera);
    }
  }

  private void check(XmlElement element, String camera, int step) {
    if (!cameras.knows(camera)) {
      throw new Attributes(element).invalid("name", "the name of a camera");
    }
    String line = "camera '%s' is not online at step %s, nothing happens".formatted(camera, step);
    if (!positions.containsKey(camera)) {
      warnings.accept(element.place("name").line(line));
    } else if (failed.contains(camera)) {
      warnings.accept(
          element.place("name").line(line + " (unless camsim --quirks lets it come back)"));
    }
  }
}
