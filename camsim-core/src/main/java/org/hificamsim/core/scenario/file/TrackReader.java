package org.hificamsim.core.scenario.file;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.track.Track;

/**
 * Reads the file of tracks that {@link TrackWriter} writes, with its targets in the order of the
 * file.
 */
final class TrackReader {
  /** The greatest number of samples in a file; each takes 24 bytes. */
  static final int MAX_SAMPLES = 20_000_000;

  private static final String EXPECTED_TIME = "a number of seconds from 0, later than before";

  private final TextLines lines;
  private final double stepTime;
  private final List<TargetSpec> tracks = new ArrayList<>();
  private final Map<Double, Double> lastTimes = new HashMap<>();

  /** The time, x and y of each sample of the current target. */
  private DoubleStream.Builder samples = DoubleStream.builder();

  /** The place where the current target begins; null before the first. */
  private Place targetPlace;

  private TargetSpec target;
  private double interval;

  /** The time of the target's last sample; NaN before the first. */
  private double lastTime;

  /** The last time that was written out. */
  private double writtenTime;

  private int samplesSinceWrittenTime;
  private long total;

  /**
   * @param stepTime the step time, in seconds, above 0
   */
  TrackReader(TextLines lines, double stepTime) {
    this.lines = lines;
    this.stepTime = stepTime;
  }

  /**
   * Reads all targets.
   *
   * @throws InputException if the file is invalid
   */
  List<TargetSpec> tracks() {
    header();
    while (lines.nextFields()) {
      if (lines.text(0).equals("target")) {
        end();
        begin();
      } else {
        sample();
      }
    }
    end();
    return tracks;
  }

  private void header() {
    if (!lines.nextFields()
        || lines.count() != 2
        || !lines.text().strip().equals(TrackWriter.HEADER)) {
      throw lines.place().error("expected '" + TrackWriter.HEADER + "' as the first line");
    }
    if (!lines.nextFields() || !lines.text(0).equals("interval")) {
      throw lines.place().error("expected 'interval' and a number of seconds");
    }
    interval = number(1, "interval", Range.POSITIVE_TIME);
    requireFields(2);
  }

  private double number(int field, String name, Range range) {
    return lines.number(field, name, range.expected(), range::contains);
  }

  private void requireFields(int limit) {
    if (lines.count() > limit) {
      throw lines.invalid(limit, "a further field", "the end of the line");
    }
  }

  private void begin() {
    targetPlace = lines.place(0);
    samples = DoubleStream.builder();
    lastTime = Double.NaN;
    target =
        new TargetSpec(lines.number(1, "target"), 0, 0)
            .with(TargetSpec.ORIGIN, TargetSpec.Origin.TRACK)
            .with(TargetSpec.MOVE, TargetSpec.TRACKS);
    if (word(2).equals("width")) {
      double width = number(3, "width", Range.POSITIVE_LENGTH);
      requireWord(4, "height");
      target = target.withExtent(new Extent(width, number(5, "height", Range.POSITIVE_LENGTH)));
      requireFields(6);
    } else {
      requireWord(2, "size");
      target = target.withSize(number(3, "size", Range.POSITIVE_LENGTH));
      requireFields(4);
    }
  }

  private String word(int field) {
    return field < lines.count() ? lines.text(field) : "";
  }

  private void requireWord(int field, String word) {
    if (!word(field).equals(word)) {
      throw lines.invalid(field, "the word", "'" + word + "' and a number of metres");
    }
  }

  private void sample() {
    if (targetPlace == null) {
      throw lines.invalid(0, "the line", "'target', its number, 'size' and metres");
    }
    requireFields(3);
    int xField = Math.max(0, lines.count() - 2);
    if (xField == 1) {
      writtenTime = lines.number(0, "time", EXPECTED_TIME, this::isLater);
      samplesSinceWrittenTime = 0;
    } else if (Double.isNaN(lastTime)) {
      throw lines.invalid(2, "time, x and y", "all three in a track's first line");
    }
    requireRoom();
    lastTime = writtenTime + samplesSinceWrittenTime++ * interval;
    samples
        .add(lastTime)
        .add(number(xField, "x", Range.COORDINATE))
        .add(number(xField + 1, "y", Range.COORDINATE));
  }

  private boolean isLater(double time) {
    double before =
        Double.isNaN(lastTime) ? lastTimes.getOrDefault(target.features(), -1.0) : lastTime;
    return time >= 0 && time <= 1e9 && time > before;
  }

  private void requireRoom() {
    if (++total > MAX_SAMPLES) {
      throw lines.place().error("too many samples, expected at most " + MAX_SAMPLES);
    }
  }

  private void end() {
    if (targetPlace == null) {
      return;
    }
    if (Double.isNaN(lastTime)) {
      throw targetPlace.error("a target without a sample, expected lines of time, x and y");
    }
    lastTimes.put(target.features(), lastTime);
    Track track = new Track(samples.build().toArray(), stepTime);
    requireNear(track);
    tracks.add(
        target
            .along(track)
            .with(TargetSpec.HEADING, track.heading())
            .with(TargetSpec.SPEED, track.meanSpeed()));
  }

  private void requireNear(Track track) {
    long end = Math.max(track.firstStep(), track.lastStep());
    if (end >= Integer.MAX_VALUE) {
      throw targetPlace.error(
          "the target stays until step %s of %s s, expected one below %s: a longer step",
          end, stepTime, Integer.MAX_VALUE);
    }
  }
}
