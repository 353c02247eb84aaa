package org.hificamsim.bridge.run;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.scenario.track.Track;
import org.hificamsim.core.scenario.track.TrackWalk;

/** CamSim's objects, where their tracks have them. */
final class TrackedObjects {
  private static final double NEAR = 1e-6; // m

  private final Map<String, List<Track>> tracks; // by features
  private final CamSim camsim;
  private final IdentityHashMap<Object, Optional<Walker>> walkers = new IdentityHashMap<>();
  private long step;

  TrackedObjects(Map<String, List<Track>> tracks, CamSim camsim) {
    this.tracks = tracks;
    this.camsim = camsim;
  }

  /** An object on its way. */
  private static final class Walker {
    private final TrackWalk walk = new TrackWalk();
    private final long lastStep;
    private long step;
    private boolean left; // the place where CamSim has it

    private Walker(Track track, long firstStep) {
      walk.begin(track, firstStep);
      step = firstStep;
      lastStep = track.lastStep();
    }

    private void goTo(long newStep) {
      while (step < Math.min(newStep, lastStep)) {
        walk.next();
        step++;
      }
    }
  }

  /** A step begins. */
  void begin(long newStep) {
    step = newStep;
  }

  /**
   * Where an object is: its own place where it has no track.
   *
   * @param upwards whether y is asked for, and not x
   */
  double place(Object object, boolean upwards, double own) {
    Optional<Walker> known = walkers.get(object);
    if (known == null) {
      known =
          tracks.getOrDefault(camsim.features(object), List.of()).stream()
              .filter(track -> track.firstStep() <= step && step <= track.lastStep())
              .findFirst()
              .map(track -> new Walker(track, step));
      walkers.put(object, known);
    }
    return known.isEmpty() ? own : place(known.get(), upwards, own);
  }

  private double place(Walker walker, boolean upwards, double own) {
    walker.goTo(step);
    double place = upwards ? walker.walk.y() : walker.walk.x();
    walker.left |= Math.abs(place - own) > NEAR;
    return place;
  }

  /** Whether an object is, by its track, where CamSim does not have it. */
  boolean hasLeft(Object object) {
    Optional<Walker> known = walkers.get(object);
    return known != null && known.isPresent() && known.get().left;
  }
}
