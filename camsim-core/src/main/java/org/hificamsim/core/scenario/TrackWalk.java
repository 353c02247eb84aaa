package org.hificamsim.core.scenario;

/**
 * Follows a track step by step: where the target is at the step's number times the length of a
 * step, on the straight line between two samples. Before its first sample and after its last one it
 * is there.
 */
public final class TrackWalk {
  private Track track;
  private long step;
  private int leg; // from this sample to the next
  private double x;
  private double y;

  /** Begins to follow a track at a step. */
  public void begin(Track newTrack, long firstStep) {
    track = newTrack;
    step = firstStep - 1;
    leg = 0;
    next();
  }

  /** Goes on by one step. */
  public void next() {
    step++;
    double time = step * track.stepTime();
    int end = track.samples() - 1;
    while (leg < end && track.time(leg + 1) <= time) {
      leg++;
    }
    x = track.x(leg);
    y = track.y(leg);
    if (leg < end) {
      double from = track.time(leg);
      double part = Math.max(0, (time - from) / (track.time(leg + 1) - from));
      x += part * (track.x(leg + 1) - x);
      y += part * (track.y(leg + 1) - y);
    }
  }

  /** Metres. */
  public double x() {
    return x;
  }

  /** Metres. */
  public double y() {
    return y;
  }
}
