package org.hificamsim.tracks.format;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;

/**
 * A cubic curve through control points in time. The velocity at each point leads from the point
 * before to the point after (Catmull and Rom 1974, for points at unequal times). If points are on a
 * line and evenly spaced, the samples are as well.
 */
final class Spline {
  /**
   * The greatest number of frames between two control points: more, about an hour, are a mistake.
   */
  private static final double MAX_FRAMES = 100_000;

  /** A control point. */
  private record Control(double frame, double x, double y) {}

  private final Place place;
  private final String target;
  private final List<Control> controls = new ArrayList<>();

  /**
   * @param place where the spline begins
   */
  Spline(Place place, String target) {
    this.place = place;
    this.target = target;
  }

  /**
   * Adds the next control point; a point at the frame of the previous one is ignored.
   *
   * @throws org.hificamsim.core.InputException if it is at an earlier frame than the one before, or
   *     much later
   */
  void add(Place at, double frame, double x, double y) {
    double last = controls.isEmpty() ? Double.NEGATIVE_INFINITY : last().frame;
    if (frame < last || (!controls.isEmpty() && frame - last > MAX_FRAMES)) {
      throw at.error(
          "the frame goes from %s to %s, expected control points in order of time, less than"
              + " 100,000 frames apart",
          last, frame);
    }
    if (frame > last) {
      controls.add(new Control(frame, x, y));
    }
  }

  private Control last() {
    return controls.get(controls.size() - 1);
  }

  /**
   * Returns the samples at multiples of a number of frames; the first point if the spline is too
   * short for one.
   */
  List<TrackSample> sampleEvery(int frames) {
    List<TrackSample> samples = new ArrayList<>();
    for (int i = 0; i + 1 < controls.size(); i++) {
      double end = controls.get(i + 1).frame;
      boolean isLast = i + 2 == controls.size();
      for (double frame = Math.ceil(controls.get(i).frame / frames) * frames;
          frame < end || (isLast && frame == end);
          frame += frames) {
        samples.add(sample(i, frame));
      }
    }
    if (samples.isEmpty() && !controls.isEmpty()) {
      Control first = controls.get(0);
      samples.add(new TrackSample(place, target, first.frame, first.x, first.y));
    }
    return samples;
  }

  /** The sample between a control point and the next one: a cubic Hermite polynomial. */
  private TrackSample sample(int i, double frame) {
    Control from = controls.get(i);
    Control to = controls.get(i + 1);
    double length = to.frame - from.frame;
    double t = (frame - from.frame) / length;
    double endWeight = t * t * (3 - 2 * t);
    double startVelocityWeight = t * (1 - t) * (1 - t) * length;
    double endVelocityWeight = t * t * (t - 1) * length;
    return new TrackSample(
        place,
        target,
        frame,
        from.x
            + endWeight * (to.x - from.x)
            + startVelocityWeight * velocityX(i)
            + endVelocityWeight * velocityX(i + 1),
        from.y
            + endWeight * (to.y - from.y)
            + startVelocityWeight * velocityY(i)
            + endVelocityWeight * velocityY(i + 1));
  }

  private double velocityX(int i) {
    return (after(i).x - before(i).x) / (after(i).frame - before(i).frame);
  }

  private double velocityY(int i) {
    return (after(i).y - before(i).y) / (after(i).frame - before(i).frame);
  }

  private Control before(int i) {
    return controls.get(Math.max(0, i - 1));
  }

  private Control after(int i) {
    return controls.get(Math.min(controls.size() - 1, i + 1));
  }
}
