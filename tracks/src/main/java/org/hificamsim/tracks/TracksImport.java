package org.hificamsim.tracks;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.file.TrackWriter;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.tracks.RecordedTarget.Sample;
import org.hificamsim.tracks.format.Clock;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.TrackFormat;
import org.hificamsim.tracks.ground.Ground;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/** Reads and checks a recording, and writes it as a file of tracks. */
public final class TracksImport {
  /** The tolerance within which a sample's time is rounded to the interval, seconds. */
  private static final double TIME_TOLERANCE = 1e-6;

  private final Recording recording;
  private final Collector collector;
  private final double secondsPerTick;
  private final double firstTick;

  /** The usual time between two samples of a target, seconds. */
  private final double interval;

  /**
   * Reads a recording.
   *
   * @param projection converts degrees to metres
   * @throws org.hificamsim.core.InputException if the file or a setting of the recording is wrong
   */
  public TracksImport(
      TrackFormat format,
      Recording recording,
      Optional<Homography> homography,
      LocalProjection projection) {
    this.recording = recording;
    collector = new Collector(unit -> Ground.of(unit, homography, projection));
    Clock clock = format.read(recording, collector);
    double spacing = collector.spacing();
    secondsPerTick = clock.secondsPerTick(spacing);
    firstTick = collector.firstTick();
    interval = Math.max(TIME_TOLERANCE, Math.rint(spacing * secondsPerTick * 1e6) / 1e6);
    requireSamples(!collector.targets().isEmpty());
  }

  /**
   * Returns what the tracks are like.
   *
   * @param obstacles the summary reports tracks that pass through them
   * @throws org.hificamsim.core.InputException if the settings leave no samples of the recording
   */
  public ImportSummary summary(TrackSettings settings, Obstacles obstacles) {
    ImportSummary summary = new ImportSummary(collector, interval, gap(settings), obstacles);
    for (RecordedTarget target : collector.targets()) {
      summary.add(target.name(), tracks(target, settings));
    }
    requireSamples(summary.samples() > 0);
    return summary;
  }

  /**
   * Writes the tracks. Targets keep their names if all are whole numbers, otherwise they become 1,
   * 2, 3, ... in the order of their first samples.
   *
   * @param folder in which the file is written
   * @param name of the file
   */
  public void write(TrackSettings settings, OutputFolder folder, String name) throws IOException {
    boolean keepsNames = collector.hasNumericNames();
    int count = 0;
    try (Writer out = folder.open(name)) {
      TrackWriter writer = new TrackWriter(out, interval, TIME_TOLERANCE);
      for (RecordedTarget target : collector.targets()) {
        count++;
        double number = keepsNames ? Double.parseDouble(target.name()) : count;
        Optional<Extent> extent = target.extent().or(settings::extent);
        write(writer, number, extent, settings.size(), tracks(target, settings));
      }
    }
  }

  private List<List<Sample>> tracks(RecordedTarget target, TrackSettings settings) {
    return target.tracks(firstTick, secondsPerTick, settings, gap(settings));
  }

  private double gap(TrackSettings settings) {
    return settings.gap().orElse(3 * interval);
  }

  private static void write(
      TrackWriter writer,
      double number,
      Optional<Extent> extent,
      double size,
      List<List<Sample>> tracks)
      throws IOException {
    for (List<Sample> track : tracks) {
      if (extent.isPresent()) {
        writer.target(number, extent.get());
      } else {
        writer.target(number, size);
      }
      for (Sample sample : track) {
        writer.sample(sample.time(), sample.x(), sample.y());
      }
    }
  }

  private void requireSamples(boolean present) {
    if (!present) {
      throw recording.missing("samples of targets; the file, or what is cut from it, has none");
    }
  }
}
