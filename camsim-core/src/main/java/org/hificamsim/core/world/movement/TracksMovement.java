package org.hificamsim.core.world.movement;

import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.scenario.Track;
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
  private Track track;
  private long step;
  private int leg; // from this sample to the next

  @Override
  public String name() {
    return "Tracks";
  }

  @Override
  public void start(int target, Targets targets, TargetSpec spec) {
    if (spec.movement().track().isEmpty()) {
      throw new InputException(
          "target " + spec.name() + " moves by Tracks and has no track, expected one of <tracks>");
    }
    track = spec.movement().track().get();
    step = track.firstStep() - (targets.moveFirst() ? 1 : 0);
    put(target, targets);
  }

  @Override
  public void move(int target, Targets targets, RandomStreams random) {
    step++;
    put(target, targets);
  }

  private void put(int target, Targets targets) {
    double time = step * track.stepTime();
    int last = track.samples() - 1;
    while (leg < last && track.time(leg + 1) <= time) {
      leg++;
    }
    if (leg == last) {
      targets.put(target, track.x(last), track.y(last));
    } else {
      putOnLeg(target, targets, time);
    }
  }

  private void putOnLeg(int target, Targets targets, double time) {
    double from = track.time(leg);
    double duration = track.time(leg + 1) - from;
    double part = Math.max(0, (time - from) / duration);
    double dx = track.x(leg + 1) - track.x(leg);
    double dy = track.y(leg + 1) - track.y(leg);
    targets.put(target, track.x(leg) + part * dx, track.y(leg) + part * dy);
  }
}
