package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.tracks.format.TrackSample;

/**
 * A target of a recording: its samples on the ground in order of time, and the size of its boxes.
 */
final class RecordedTarget {
  private static final double MICRO = 1e6;
  private static final double MILLI = 1e3;

  /**
   * When and where a target was.
   *
   * @param time ticks of the recording; of a track, seconds
   * @param x metres
   * @param y metres
   */
  record Sample(double time, double x, double y) {}

  private final String name;
  private final List<Sample> samples = new ArrayList<>();
  private final DoubleSummaryStatistics widths = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics heights = new DoubleSummaryStatistics();

  RecordedTarget(String name) {
    this.name = name;
  }

  /** As the file says it. */
  String name() {
    return name;
  }

  /** One or more, by time in ticks. */
  List<Sample> samples() {
    return samples;
  }

  /**
   * Takes the next sample.
   *
   * @return whether it is new, not the last one again
   * @throws InputException when it is earlier, or at another place at the same time
   */
  boolean add(TrackSample read) {
    Sample last = samples.isEmpty() ? null : samples.get(samples.size() - 1);
    if (last != null && read.tick() < last.time()) {
      throw fault(
          read,
          ": time runs backwards, from %s to %s, expected a target's samples in order of time"
              .formatted(last.time(), read.tick()));
    }
    if (last != null && read.tick() == last.time()) {
      if (last.x() != read.x() || last.y() != read.y()) {
        throw fault(
            read,
            " is at two places at time %s, expected one sample of a target at a time"
                .formatted(read.tick()));
      }
      return false;
    }
    samples.add(new Sample(read.tick(), read.x(), read.y()));
    if (isLength(read.width()) && isLength(read.height())) {
      widths.accept(read.width());
      heights.accept(read.height());
    }
    return true;
  }

  private static InputException fault(TrackSample sample, String problem) {
    return sample.place().error("target " + sample.target() + problem);
  }

  private static boolean isLength(double metres) {
    return metres > 0 && metres <= 1e9;
  }

  /** The mean of its boxes; empty where the file has none. */
  Optional<Extent> extent() {
    return widths.getCount() == 0
        ? Optional.empty()
        : Optional.of(new Extent(size(widths.getAverage()), size(heights.getAverage())));
  }

  private static double size(double metres) {
    return Math.max(1e-3, rounded(metres, MILLI));
  }

  private static double rounded(double value, double parts) {
    return Math.rint(value * parts) / parts;
  }

  /**
   * Its tracks: a new one at first and after each gap. Times are kept to the microsecond, places to
   * the millimetre.
   *
   * @param first when the recording's first sample was taken, ticks
   * @param secondsPerTick how long a tick is
   * @param settings say what is cut out
   * @param gap the longest time between two samples of a track, seconds
   */
  List<List<Sample>> tracks(
      double first, double secondsPerTick, TrackSettings settings, double gap) {
    List<List<Sample>> tracks = new ArrayList<>();
    Sample last = null;
    for (Sample sample : samples) {
      double seconds = (sample.time() - first) * secondsPerTick;
      double when = rounded(seconds - settings.from(), MICRO);
      boolean kept = seconds >= settings.from() && seconds <= settings.to();
      if (kept && (last == null || when > last.time())) { // not less than a microsecond later
        if (last == null || when - last.time() > gap * (1 + 1e-9)) {
          tracks.add(new ArrayList<>());
        }
        last = new Sample(when, rounded(sample.x(), MILLI), rounded(sample.y(), MILLI));
        tracks.get(tracks.size() - 1).add(last);
      }
    }
    return tracks;
  }
}
