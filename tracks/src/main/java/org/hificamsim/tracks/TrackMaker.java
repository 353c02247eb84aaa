package org.hificamsim.tracks;

import java.io.IOException;
import java.util.Optional;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Extent;
import org.hificamsim.core.scenario.TrackWriter;
import org.hificamsim.tracks.Collector.TargetRecord;

/**
 * Writes the samples of a target as tracks: a new one at first and after each gap. Times are kept
 * to the microsecond, places to the millimetre.
 */
final class TrackMaker {
  private static final double MICRO = 1e6;
  private static final double MILLI = 1e3;

  private final TrackSettings settings;
  private final TrackWriter writer;
  private final TargetRecord target;
  private final double number;
  private final ImportSummary summary;
  private long samples;
  private double time;
  private Point at;

  /**
   * @param number by which the scenario knows the target
   */
  TrackMaker(
      TrackSettings settings,
      TrackWriter writer,
      TargetRecord target,
      double number,
      ImportSummary summary) {
    this.settings = settings;
    this.writer = writer;
    this.target = target;
    this.number = number;
    this.summary = summary;
  }

  /** Adds the next sample, seconds from the recording's first one and metres. */
  void sample(double seconds, double x, double y) throws IOException {
    double when = Math.rint((seconds - settings.from()) * MICRO) / MICRO;
    boolean cut = seconds < settings.from() || seconds > settings.to();
    if (!cut && (samples == 0 || when > time)) { // not less than a microsecond later
      write(when, new Point(Math.rint(x * MILLI) / MILLI, Math.rint(y * MILLI) / MILLI));
    }
  }

  private void write(double when, Point to) throws IOException {
    boolean gap = samples > 0 && when - time > summary.gap() * (1 + 1e-9);
    if (gap) {
      summary.gap(when - time);
    }
    if (gap || samples == 0) {
      begin();
    } else {
      summary.leg(target, when, when - time, at, to);
    }
    summary.sample(when, to.x(), to.y());
    writer.sample(when, to.x(), to.y());
    samples++;
    time = when;
    at = to;
  }

  private void begin() throws IOException {
    Optional<Extent> extent = target.extent().or(settings::extent);
    if (extent.isPresent()) {
      writer.target(number, extent.get());
    } else {
      writer.target(number, settings.size());
    }
  }

  /** No sample follows. */
  void end() {
    summary.endTarget(samples);
  }
}
