package org.hificamsim.core.world;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.visibility.Pose;

/**
 * All cameras and targets that a scenario will ever have, by number, and the events in their order;
 * found once, for any number of worlds.
 *
 * <p>Cameras and targets are numbered in the order of the file, those of the start first, then
 * those that events add, in the order in which they appear.
 */
final class Participants {
  /** What an event removes that removes no target. */
  static final int NONE = -1;

  private final Scenario scenario;
  private final Views views;
  private final ScenarioEvent[] events;
  private final int[] removed;
  private final List<CameraSpec> cameras = new ArrayList<>();
  private final List<TargetSpec> targets = new ArrayList<>();
  private final List<Mount> mounts;
  private final Map<String, Integer> cameraNumbers = new HashMap<>();

  Participants(Scenario scenario) {
    this.scenario = scenario;
    this.views = new Views(scenario);
    this.events =
        scenario.events().stream()
            .sorted(Comparator.comparingInt(ScenarioEvent::step))
            .toArray(ScenarioEvent[]::new);
    collect();
    removed = removed();
    mounts = cameras.stream().map(this::mount).toList();
    for (int camera = 0; camera < cameras.size(); camera++) {
      cameraNumbers.putIfAbsent(cameras.get(camera).name(), camera);
    }
  }

  private void collect() {
    cameras.addAll(scenario.cameras());
    targets.addAll(scenario.targets());
    for (ScenarioEvent event : events) {
      if (event instanceof ScenarioEvent.AddCamera add) {
        cameras.add(add.camera());
      } else if (event instanceof ScenarioEvent.AddTarget add) {
        targets.add(add.target());
      }
    }
  }

  private Mount mount(CameraSpec spec) {
    Pose pose = Pose.of(spec.x(), spec.y(), Math.toRadians(spec.heading()));
    return views.mount(pose, views.of(spec));
  }

  /** Who removes whom is known from the start: a search in each step would cost and allocate. */
  private int[] removed() {
    Map<Double, Deque<Integer>> present = new HashMap<>(); // one each, if a file was read
    int next = 0;
    for (TargetSpec target : scenario.targets()) {
      present.computeIfAbsent(target.features(), any -> new ArrayDeque<>()).add(next++);
    }
    int[] numbers = new int[events.length];
    Arrays.fill(numbers, NONE);
    for (int i = 0; i < events.length; i++) {
      if (events[i] instanceof ScenarioEvent.AddTarget add) {
        present.computeIfAbsent(add.target().features(), any -> new ArrayDeque<>()).add(next++);
      } else if (events[i] instanceof ScenarioEvent.RemoveTarget remove) {
        Deque<Integer> same = present.getOrDefault(remove.features(), new ArrayDeque<>());
        numbers[i] = same.isEmpty() ? NONE : same.remove();
      }
    }
    return numbers;
  }

  Scenario scenario() {
    return scenario;
  }

  Views views() {
    return views;
  }

  int events() {
    return events.length;
  }

  ScenarioEvent event(int number) {
    return events[number];
  }

  /** The target that an event removes, or {@link #NONE}. */
  int removed(int event) {
    return removed[event];
  }

  int cameras() {
    return mounts.size();
  }

  CameraSpec camera(int number) {
    return cameras.get(number);
  }

  /** How a camera is mounted when it is added. */
  Mount mount(int camera) {
    return mounts.get(camera);
  }

  /** The number of a camera; of several with the name the first; -1 for none. */
  int cameraNumber(String name) {
    return cameraNumbers.getOrDefault(name, -1);
  }

  int targets() {
    return targets.size();
  }

  TargetSpec target(int number) {
    return targets.get(number);
  }
}
