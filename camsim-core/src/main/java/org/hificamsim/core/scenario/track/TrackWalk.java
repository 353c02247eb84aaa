package org.hificamsim.core.scenario.track;

/**
 * Follows a track step by step: where the target is at the step's number times the length of a
 * step, on the straight line between two samples. Before its first sample and after its last one it
 * is there. Steps whose places were computed in advance are read, and nothing else is touched.
 */
public final class TrackWalk {
  private final double[] worked = new double[2];
  private Track track;
  private double[] coordinates; // x and y in turn, of this step and of some that follow
  private int at; // of this step
  private int last; // of the last step there
  private long step; // the last step there
  private int leg; // from this sample to the next

  /** Begins to follow a track at a step. */
  public void begin(Track newTrack, long firstStep) {
    track = newTrack;
    step = firstStep;
    leg = 0;
    find();
  }

  /** Goes on by one step. */
  public void next() {
    if (at < last) {
      at += 2;
    } else {
      step++;
      find();
    }
  }

  /** Metres. */
  public double x() {
    return coordinates[at];
  }

  /** Metres. */
  public double y() {
    return coordinates[at + 1];
  }

  private void find() {
    StepPlaces places = track.places();
    if (places == null || !places.has(step)) {
      workOut();
      return;
    }
    int more = places.following(step);
    coordinates = places.coordinates();
    at = places.at(step);
    last = at + 2 * more;
    step += more;
  }

  private void workOut() {
    coordinates = worked;
    at = 0;
    last = 0;
    double time = step * track.stepTime();
    int end = track.samples() - 1;
    while (leg < end && track.time(leg + 1) <= time) {
      leg++;
    }
    if (leg == end) {
      worked[0] = track.x(end);
      worked[1] = track.y(end);
    } else {
      workOut(time);
    }
  }

  private void workOut(double time) {
    double from = track.time(leg);
    double part = Math.max(0, (time - from) / (track.time(leg + 1) - from));
    worked[0] = track.x(leg) + part * (track.x(leg + 1) - track.x(leg));
    worked[1] = track.y(leg) + part * (track.y(leg + 1) - track.y(leg));
  }
}
