package org.hificamsim.core.scenario;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The targets of a scenario that follow tracks. Each came with two events, which add and remove it.
 *
 * @param additions the events that add them, in order
 */
record TrackedTargets(List<ScenarioEvent.AddTarget> additions) {
  private static final double NANOS = 1e9; // in a second

  /** Those among a scenario's events. */
  static TrackedTargets of(List<ScenarioEvent> events) {
    return new TrackedTargets(
        events.stream()
            .filter(ScenarioEvent.AddTarget.class::isInstance)
            .map(ScenarioEvent.AddTarget.class::cast)
            .filter(TrackedTargets::isTracked)
            .toList());
  }

  /** The events that no track brings with it. */
  List<ScenarioEvent> others(List<ScenarioEvent> events) {
    Set<ScenarioEvent> removals = new HashSet<>();
    for (ScenarioEvent.AddTarget add : additions) {
      removals.add(track(add).removal(add.target().features()));
    }
    return events.stream()
        .filter(event -> !(event instanceof ScenarioEvent.AddTarget add) || !isTracked(add))
        .filter(event -> !removals.contains(event))
        .toList();
  }

  /** Writes them as a file of tracks; there is at least one. */
  void write(Appendable out) throws IOException {
    TrackWriter writer = new TrackWriter(out, interval(track(additions.get(0))), 0);
    for (ScenarioEvent.AddTarget add : additions) {
      write(writer, add.target(), track(add));
    }
  }

  private static void write(TrackWriter writer, TargetSpec target, Track track) throws IOException {
    if (target.extent().isPresent()) {
      writer.target(target.features(), target.extent().get());
    } else {
      writer.target(target.features(), target.size());
    }
    for (int i = 0; i < track.samples(); i++) {
      writer.sample(track.time(i), track.x(i), track.y(i));
    }
  }

  /** Between its first two samples, to the nanosecond. */
  private static double interval(Track track) {
    double interval = track.samples() == 1 ? 1 : track.time(1) - track.time(0);
    return Math.max(1, Math.rint(interval * NANOS)) / NANOS;
  }

  private static boolean isTracked(ScenarioEvent.AddTarget add) {
    return add.target().track().isPresent();
  }

  private static Track track(ScenarioEvent.AddTarget add) {
    return add.target().track().orElseThrow();
  }
}
