package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.tracks.format.TrackSample;

/**
 * A target of a recording: its samples on the ground in the order of time, and the size of its
 * boxes.
 */
final class RecordedTarget {
  private static final double PER_MICROSECOND = 1e6;
  private static final double PER_MILLIMETRE = 1e3;

  /**
   * The position of a target at one time.
   *
   * @param time in ticks of the recording, or in seconds for a track
   * @param x metres
   * @param y metres
   */
  record Sample(double time, double x, double y) {}

  private final String name;
  private final List<Sample> samples = new ArrayList<>();
  private final Set<Integer> pauses = new HashSet<>(); // before the sample with this index
  private final DoubleSummaryStatistics widths = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics heights = new DoubleSummaryStatistics();

  RecordedTarget(String name) {
    this.name = name;
  }

  /** The name in the file. */
  String name() {
    return name;
  }

  /** The samples, one or more, in the order of time, with times in ticks. */
  List<Sample> samples() {
    return samples;
  }

  /** Makes the target absent from its last sample to the next one. */
  void pause() {
    pauses.add(samples.size());
  }

  /** Returns this target under another name, with times in other units. */
  RecordedTarget renamed(String newName, double unitsPerTick) {
    RecordedTarget renamed = new RecordedTarget(newName);
    for (Sample sample : samples) {
      renamed.samples.add(new Sample(sample.time() * unitsPerTick, sample.x(), sample.y()));
    }
    renamed.pauses.addAll(pauses);
    renamed.widths.combine(widths);
    renamed.heights.combine(heights);
    return renamed;
  }

  /** Adds the samples of the same target in another file, which are all later. */
  void append(RecordedTarget later) {
    later.pauses.forEach(index -> pauses.add(samples.size() + index));
    samples.addAll(later.samples);
    widths.combine(later.widths);
    heights.combine(later.heights);
  }

  double firstTime() {
    return samples.get(0).time();
  }

  double lastTime() {
    return samples.get(samples.size() - 1).time();
  }

  /**
   * Adds the next sample.
   *
   * @return false if it repeats the last one, and is ignored
   * @throws InputException if it is earlier than the last one, or at another place at the same time
   */
  boolean add(TrackSample sample) {
    Sample last = samples.isEmpty() ? null : samples.get(samples.size() - 1);
    if (last != null && sample.tick() < last.time()) {
      throw error(
          sample,
          ": time runs backwards, from %s to %s, expected a target's samples in order of time"
              .formatted(last.time(), sample.tick()));
    }
    if (last != null && sample.tick() == last.time()) {
      if (last.x() != sample.x() || last.y() != sample.y()) {
        throw error(
            sample,
            " is at two places at time %s, expected one sample of a target at a time"
                .formatted(sample.tick()));
      }
      pauses.remove(samples.size()); // the parts meet
      return false;
    }
    samples.add(new Sample(sample.tick(), sample.x(), sample.y()));
    if (isLength(sample.width()) && isLength(sample.height())) {
      widths.accept(sample.width());
      heights.accept(sample.height());
    }
    return true;
  }

  private static InputException error(TrackSample sample, String problem) {
    return sample.place().error("target " + sample.target() + problem);
  }

  private static boolean isLength(double metres) {
    return metres > 0 && metres <= 1e9;
  }

  /** The mean size of its boxes; empty if the file has none. */
  Optional<Extent> extent() {
    return widths.getCount() == 0
        ? Optional.empty()
        : Optional.of(new Extent(size(widths.getAverage()), size(heights.getAverage())));
  }

  private static double size(double metres) {
    return Math.max(1e-3, rounded(metres, PER_MILLIMETRE));
  }

  private static double rounded(double value, double perUnit) {
    return Math.rint(value * perUnit) / perUnit;
  }

  /**
   * Cuts the samples into tracks wherever there is a gap or pause. Times are rounded to
   * microseconds, positions to millimetres.
   *
   * @param first the time of the recording's first sample, ticks
   * @param settings the part of the recording that is kept
   * @param gap the longest time between two samples of a track, seconds
   */
  List<List<Sample>> tracks(
      double first, double secondsPerTick, TrackSettings settings, double gap) {
    List<List<Sample>> tracks = new ArrayList<>();
    Sample last = null;
    for (int i = 0; i < samples.size(); i++) {
      Sample sample = samples.get(i);
      double seconds = (sample.time() - first) * secondsPerTick;
      double time = rounded(seconds - settings.from(), PER_MICROSECOND);
      boolean kept = seconds >= settings.from() && seconds <= settings.to();
      if (kept && (last == null || time > last.time())) { // rounded times may be equal
        if (last == null || pauses.contains(i) || time - last.time() > gap * (1 + 1e-9)) {
          tracks.add(new ArrayList<>());
        }
        last =
            new Sample(
                time, rounded(sample.x(), PER_MILLIMETRE), rounded(sample.y(), PER_MILLIMETRE));
        tracks.get(tracks.size() - 1).add(last);
      }
    }
    return tracks;
  }
}
