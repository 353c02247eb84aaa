package org.hificamsim.core.world.movement;

import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Track;
import org.hificamsim.core.scenario.TrackWalk;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * A recorded track: when cameras look in step n the target is where it was at n times the length of
 * a step, on the straight line between two samples, whatever stands in its way. At the track's end
 * it stays until it is removed. Heading and speed are those of its start: working them out would
 * cost more than the step, and nobody looks at them.
 */
final class TracksMovement implements Movement {
  private final TrackWalk walk = new TrackWalk();

  @Override
  public String name() {
    return "Tracks";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    if (spec.track().isEmpty()) { // in no lambda, since a step in which it comes allocates nothing
      throw new InputException(
          "target " + spec.name() + " moves by Tracks and has no track, expected one of <tracks>");
    }
    Track track = spec.track().get();
    walk.begin(track, track.firstStep() - (targets.moveFirst() ? 1 : 0));
    targets.put(target, walk.x(), walk.y());
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    walk.next();
    targets.put(target, walk.x(), walk.y());
  }
}
