package org.hificamsim.bridge.run;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.scenario.track.TrackWalk;

/** Moves CamSim's objects along their tracks. */
final class TrackedObjects {
  /** The greatest distance in x or y of an object that is on its track, in metres. */
  private static final double TOLERANCE = 1e-6;

  /** The tracks by the features of their object. */
  private final Map<String, List<Track>> tracks;

  private final CamSim camsim;
  private final IdentityHashMap<Object, Optional<Walker>> walkers = new IdentityHashMap<>();
  private long step;

  TrackedObjects(Map<String, List<Track>> tracks, CamSim camsim) {
    this.tracks = tracks;
    this.camsim = camsim;
  }

  /** An object on its track. */
  private static final class Walker {
    private final TrackWalk walk = new TrackWalk();
    private final long lastStep;
    private long step;

    /** Whether the track has ever differed from the position that CamSim has. */
    private boolean hasLeft;

    private Walker(Track track, long firstStep) {
      walk.begin(track, firstStep);
      step = firstStep;
      lastStep = track.lastStep();
    }

    private void advanceTo(long newStep) {
      while (step < Math.min(newStep, lastStep)) {
        walk.next();
        step++;
      }
    }
  }

  /** Begins a step. */
  void begin(long newStep) {
    step = newStep;
  }

  /**
   * Returns a coordinate of an object on its track. An object without a track keeps the one that
   * CamSim has.
   *
   * @param isY whether to return y, else x
   * @param camSimValue the coordinate that CamSim has
   */
  double coordinate(Object object, boolean isY, double camSimValue) {
    Optional<Walker> walker = walkers.get(object);
    if (walker == null) {
      walker =
          tracks.getOrDefault(camsim.features(object), List.of()).stream()
              .filter(track -> track.firstStep() <= step && step <= track.lastStep())
              .findFirst()
              .map(track -> new Walker(track, step));
      walkers.put(object, walker);
    }
    return walker.isEmpty() ? camSimValue : coordinate(walker.get(), isY, camSimValue);
  }

  private double coordinate(Walker walker, boolean isY, double camSimValue) {
    walker.advanceTo(step);
    double coordinate = isY ? walker.walk.y() : walker.walk.x();
    walker.hasLeft |= Math.abs(coordinate - camSimValue) > TOLERANCE;
    return coordinate;
  }

  /** Returns whether the track of an object has ever differed from CamSim's position. */
  boolean hasLeft(Object object) {
    Optional<Walker> walker = walkers.get(object);
    return walker != null && walker.isPresent() && walker.get().hasLeft;
  }
}
