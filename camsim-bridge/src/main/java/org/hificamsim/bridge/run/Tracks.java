package org.hificamsim.bridge.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Track;

/** The tracks of a scenario by the features of those who follow them, in the order of time. */
public final class Tracks {
  private final Map<String, List<Track>> byFeatures = new HashMap<>();

  private Tracks() {}

  /** All tracks of a scenario. */
  public static Tracks of(Scenario scenario) {
    Tracks tracks = new Tracks();
    for (ScenarioEvent event : scenario.events()) {
      if (event instanceof ScenarioEvent.AddTarget add) {
        add.target().track().ifPresent(track -> tracks.add(add.target(), track));
      }
    }
    return tracks;
  }

  private void add(TargetSpec target, Track track) {
    byFeatures.computeIfAbsent(target.name(), name -> new ArrayList<>()).add(track);
  }

  /** Whether there is none. */
  public boolean isEmpty() {
    return byFeatures.isEmpty();
  }

  /** The track of an object that is there at a step. */
  Optional<Track> at(String features, long step) {
    return byFeatures.getOrDefault(features, List.of()).stream()
        .filter(track -> track.firstStep() <= step && step <= track.lastStep())
        .findFirst();
  }
}
