package org.hificamsim.tracks;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Extent;
import org.hificamsim.core.scenario.TrackWriter;

/**
 * Writes sorted samples as tracks: a new one for each target and after each gap. Times are kept to
 * the microsecond, places to the millimetre.
 */
final class TrackMaker {
  private static final double MICRO = 1e6;
  private static final double MILLI = 1e3;

  private final TrackSettings settings;
  private final TrackWriter writer;
  private final List<TargetRecord> targets;
  private final TargetNames names;
  private final Findings findings;
  private final double gap;
  private int target = -1;
  private double time;
  private double x;
  private double y;

  TrackMaker(
      TrackSettings settings,
      TrackWriter writer,
      List<TargetRecord> targets,
      TargetNames names,
      Findings findings) {
    this.settings = settings;
    this.writer = writer;
    this.targets = targets;
    this.names = names;
    this.findings = findings;
    this.gap = settings.gap().orElse(3 * findings.interval());
  }

  /** The longest time between two samples of a target that is there meanwhile, seconds. */
  double gap() {
    return gap;
  }

  /**
   * Writes all samples.
   *
   * @param firstTick when the recording begins
   * @param secondsPerTick how long a tick is
   */
  void write(SortedSamples samples, double firstTick, double secondsPerTick) throws IOException {
    while (samples.next()) {
      SampleRun sample = samples.sample();
      double seconds = (sample.tick() - firstTick) * secondsPerTick;
      if (seconds >= settings.from() && seconds <= settings.to()) {
        write(sample, Math.rint((seconds - settings.from()) * MICRO) / MICRO);
      }
    }
  }

  private void write(SampleRun sample, double when) throws IOException {
    double toX = Math.rint(sample.x() * MILLI) / MILLI;
    double toY = Math.rint(sample.y() * MILLI) / MILLI;
    boolean known = sample.target() == target;
    if (known && when <= time) {
      return; // less than a microsecond later
    }
    if (!known || when - time > gap * (1 + 1e-9)) {
      begin(sample.target(), known, when);
    } else {
      findings.leg(targets.get(target), when, when - time, new Point(x, y), new Point(toX, toY));
    }
    findings.sample(targets.get(sample.target()), when, toX, toY);
    writer.sample(when, toX, toY);
    target = sample.target();
    time = when;
    x = toX;
    y = toY;
  }

  private void begin(int number, boolean known, double when) throws IOException {
    findings.track();
    if (known) {
      findings.gap(when - time);
    }
    TargetRecord record = targets.get(number);
    Optional<Extent> extent = record.extent().isPresent() ? record.extent() : settings.extent();
    if (extent.isPresent()) {
      writer.target(names.number(record), extent.get());
    } else {
      writer.target(names.number(record), settings.size());
    }
  }
}
