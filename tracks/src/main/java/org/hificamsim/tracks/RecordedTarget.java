package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.tracks.format.TrackSample;

/**
 * A target of a recording: its samples on the ground and the size of its boxes. Rows may be in any
 * order until they are {@link #sort sorted}.
 */
final class RecordedTarget {
  private static final double PER_MICROSECOND = 1e6;
  private static final double PER_MILLIMETRE = 1e3;

  /**
   * The position of a target at one time.
   *
   * @param time the time in ticks of the recording, or in seconds for a track
   * @param x the x coordinate in metres
   * @param y the y coordinate in metres
   */
  record Sample(double time, double x, double y) {}

  /** A row that is at a time before that of a row above it, or at the same one. */
  record LateRow(double time, Place place) {}

  private final String name;
  private final List<Sample> samples = new ArrayList<>();
  private final List<LateRow> lateRows = new ArrayList<>();
  private final Set<Double> partStarts = new HashSet<>();
  private boolean isPaused;
  private double partStart;
  private double latest = Double.NEGATIVE_INFINITY;
  private final DoubleSummaryStatistics widths = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics heights = new DoubleSummaryStatistics();

  RecordedTarget(String name) {
    this.name = name;
  }

  /** The name in the file. */
  String name() {
    return name;
  }

  /** The samples, one or more, in the order of time once they are sorted, with times in ticks. */
  List<Sample> samples() {
    return samples;
  }

  /** Makes the target absent from its last sample to the next one. */
  void pause() {
    partStarts.add(partStart);
    isPaused = true;
  }

  /** Returns this target under another name, with times in other units. */
  RecordedTarget renamed(String newName, double unitsPerTick) {
    RecordedTarget renamed = new RecordedTarget(newName);
    for (Sample sample : samples) {
      renamed.samples.add(new Sample(sample.time() * unitsPerTick, sample.x(), sample.y()));
    }
    partStarts.forEach(time -> renamed.partStarts.add(time * unitsPerTick));
    renamed.widths.combine(widths);
    renamed.heights.combine(heights);
    return renamed;
  }

  /** Adds the samples of the same target in another file, which are all later. */
  void append(RecordedTarget later) {
    later.partStarts.stream().filter(time -> time > later.firstTime()).forEach(partStarts::add);
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
   * Adds the sample of the next row.
   *
   * @param mayBeAnother whether a row at another position than the row before, at the same time,
   *     may belong to another target with the same name
   * @return false if it repeats the row before, and is ignored
   * @throws InputException if it is at another place than the row before at the same time
   */
  boolean add(TrackSample sample, boolean mayBeAnother) {
    boolean isRepeated = !samples.isEmpty() && sample.tick() == lastTime();
    if (isRepeated && !isAt(samples.get(samples.size() - 1), sample) && !mayBeAnother) {
      throw atTwoPlaces(sample.place(), sample.target(), sample.tick());
    }
    if (isRepeated && isAt(samples.get(samples.size() - 1), sample)) {
      isPaused = false; // the parts meet
      return false;
    }
    if (sample.tick() <= latest) {
      lateRows.add(new LateRow(sample.tick(), sample.place()));
    }
    latest = Math.max(latest, sample.tick());
    add(new Sample(sample.tick(), sample.x(), sample.y()));
    if (isLength(sample.width()) && isLength(sample.height())) {
      widths.accept(sample.width());
      heights.accept(sample.height());
    }
    return true;
  }

  private void add(Sample sample) {
    if (isPaused) {
      partStarts.add(sample.time());
    }
    partStart = isPaused || samples.isEmpty() ? sample.time() : partStart;
    isPaused = false;
    samples.add(sample);
  }

  private static boolean isAt(Sample last, TrackSample sample) {
    return last.x() == sample.x() && last.y() == sample.y();
  }

  private static InputException atTwoPlaces(Place place, String target, double time) {
    return place.error(
        "target %s is at two places at time %s, expected one sample of a target at a time, and a"
            + " file for each recording",
        target, time);
  }

  /** The rows that are not in the order of time; empty if all are. */
  List<LateRow> lateRows() {
    return lateRows;
  }

  /** Whether the target is at two places at the same time. */
  boolean isAtTwoPlaces() {
    Map<Double, Sample> byTime = new HashMap<>();
    return samples.stream()
        .anyMatch(
            sample -> {
              Sample other = byTime.putIfAbsent(sample.time(), sample);
              return other != null && !other.equals(sample);
            });
  }

  /**
   * Puts the samples in the order of time, each time once.
   *
   * @throws InputException if the target is at two places at the same time
   */
  void sort() {
    List<Sample> sorted = new ArrayList<>(samples);
    sorted.sort(Comparator.comparingDouble(Sample::time));
    samples.clear();
    for (Sample sample : sorted) {
      Sample last = samples.isEmpty() ? null : samples.get(samples.size() - 1);
      if (last == null || last.time() < sample.time()) {
        samples.add(sample);
      } else if (!last.equals(sample)) {
        throw atTwoPlaces(placeOf(sample.time()), name, sample.time());
      }
    }
  }

  private Place placeOf(double time) {
    return lateRows.stream().filter(row -> row.time() == time).findFirst().orElseThrow().place();
  }

  /** Cuts the samples wherever time goes back, into targets with different names. */
  List<RecordedTarget> runs() {
    List<RecordedTarget> runs = new ArrayList<>();
    double last = Double.POSITIVE_INFINITY;
    for (Sample sample : samples) {
      if (sample.time() <= last) {
        String runName = name + (runs.isEmpty() ? "" : " (" + (runs.size() + 1) + ")");
        runs.add(new RecordedTarget(runName));
      }
      runs.get(runs.size() - 1).add(sample);
      last = sample.time();
    }
    return runs;
  }

  /** The length of the way from sample to sample, in metres. */
  double length() {
    double length = 0;
    for (int i = 1; i < samples.size(); i++) {
      Sample from = samples.get(i - 1);
      Sample to = samples.get(i);
      length += Math.hypot(to.x() - from.x(), to.y() - from.y());
    }
    return length;
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
   * @param gap the longest time between two samples of a track, in seconds
   */
  List<List<Sample>> tracks(
      double first, double secondsPerTick, TrackSettings settings, double gap) {
    List<List<Sample>> tracks = new ArrayList<>();
    Sample last = null;
    for (Sample sample : samples) {
      double seconds = (sample.time() - first) * secondsPerTick;
      double time = rounded(seconds - settings.from(), PER_MICROSECOND);
      boolean kept = seconds >= settings.from() && seconds <= settings.to();
      if (kept && (last == null || time > last.time())) { // rounded times may be equal
        if (last == null
            || partStarts.contains(sample.time())
            || time - last.time() > gap * (1 + 1e-9)) {
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
