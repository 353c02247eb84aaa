package org.hificamsim.core.scenario.track;

/**
 * Follows a track step by step and interpolates the position between two samples. Before the first
 * and after the last sample the target stays there. Precomputed positions are read from one array,
 * and no other memory is touched.
 */
public final class TrackWalk {
  private final double[] computed = new double[2];
  private Track track;

  /** The alternating x and y of the current step and of some following ones. */
  private double[] coordinates;

  /** The index of the current step in {@link #coordinates}. */
  private int index;

  /** The index of the last step in {@link #coordinates}. */
  private int lastIndex;

  /** The number of the last step in {@link #coordinates}. */
  private long lastStep;

  /** The sample before the current time. */
  private int leg;

  /** Starts to follow a track at a step. */
  public void begin(Track newTrack, long firstStep) {
    track = newTrack;
    lastStep = firstStep;
    leg = 0;
    find();
  }

  /** Moves on by one step. */
  public void next() {
    if (index < lastIndex) {
      index += 2;
    } else {
      lastStep++;
      find();
    }
  }

  /** The x coordinate, in metres. */
  public double x() {
    return coordinates[index];
  }

  /** The y coordinate, in metres. */
  public double y() {
    return coordinates[index + 1];
  }

  private void find() {
    StepPlaces places = track.places();
    if (places == null || !places.has(lastStep)) {
      compute();
      return;
    }
    int following = places.following(lastStep);
    coordinates = places.coordinates();
    index = places.indexOf(lastStep);
    lastIndex = index + 2 * following;
    lastStep += following;
  }

  private void compute() {
    coordinates = computed;
    index = 0;
    lastIndex = 0;
    double time = lastStep * track.stepTime();
    int end = track.samples() - 1;
    while (leg < end && track.time(leg + 1) <= time) {
      leg++;
    }
    if (leg == end) {
      computed[0] = track.x(end);
      computed[1] = track.y(end);
    } else {
      interpolate(time);
    }
  }

  private void interpolate(double time) {
    double from = track.time(leg);
    double part = Math.max(0, (time - from) / (track.time(leg + 1) - from));
    computed[0] = track.x(leg) + part * (track.x(leg + 1) - track.x(leg));
    computed[1] = track.y(leg) + part * (track.y(leg + 1) - track.y(leg));
  }
}
