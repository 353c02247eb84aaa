package org.hificamsim.core.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * All cameras and targets that a scenario will ever have, by number, and its events in the order of
 * time; computed once for any number of worlds.
 *
 * <p>Cameras and targets are numbered in the order of the file: first those of the start, then
 * those that events add, in the order in which they appear.
 *
 * @param removed for each event, the target that it removes, or {@link #NONE}; computed in advance,
 *     since a search within a step would take time and allocate
 * @param mounts for each camera, its mount when it is added
 * @param cameraNumbers the camera numbers by name; the first one if several cameras share a name
 */
record Participants(
    Scenario scenario,
    Views views,
    List<ScenarioEvent> events,
    List<Integer> removed,
    List<CameraSpec> cameras,
    List<Mount> mounts,
    Map<String, Integer> cameraNumbers,
    List<TargetSpec> targets) {
  /** The number of no camera, or of no target. */
  static final int NONE = -1;

  /** Numbers the cameras and targets of a scenario. */
  static Participants of(Scenario scenario) {
    List<ScenarioEvent> events =
        scenario.events().stream().sorted(Comparator.comparingInt(ScenarioEvent::step)).toList();
    Scenario inOrder = scenario.with(Scenario.EVENTS, events);
    List<CameraSpec> cameras = inOrder.everyCamera().toList();
    Views views = new Views(scenario);
    Map<String, Integer> numbers = new HashMap<>();
    for (int camera = 0; camera < cameras.size(); camera++) {
      numbers.putIfAbsent(cameras.get(camera).name(), camera);
    }
    return new Participants(
        scenario,
        views,
        events,
        removed(scenario.targets(), events),
        cameras,
        cameras.stream().map(views::mount).toList(),
        numbers,
        inOrder.everyTarget().toList());
  }

  private static List<Integer> removed(List<TargetSpec> atStart, List<ScenarioEvent> events) {
    Map<Double, Deque<Integer>> present = new HashMap<>();
    int next = 0;
    for (TargetSpec target : atStart) {
      present.computeIfAbsent(target.features(), features -> new ArrayDeque<>()).add(next++);
    }
    List<Integer> removed = new ArrayList<>();
    for (ScenarioEvent event : events) {
      Integer number = null;
      if (event instanceof ScenarioEvent.AddTarget add) {
        present
            .computeIfAbsent(add.target().features(), features -> new ArrayDeque<>())
            .add(next++);
      } else if (event instanceof ScenarioEvent.RemoveTarget remove) {
        number = present.getOrDefault(remove.features(), new ArrayDeque<>()).poll();
      }
      removed.add(number == null ? NONE : number);
    }
    return removed;
  }
}
