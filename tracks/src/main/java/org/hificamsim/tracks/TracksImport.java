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
import org.hificamsim.tracks.format.FormatChoice;
import org.hificamsim.tracks.ground.Ground;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/** Reads and checks a recording, and writes it as a file of tracks. */
public final class TracksImport {
  /** The tolerance within which a sample's time is rounded to the interval, seconds. */
  private static final double TIME_TOLERANCE = 1e-6;

  private final List<FormatChoice> files;
  private final RecordedTargets recorded;
  private final double firstTick;

  /** The usual time between two samples of a target, seconds. */
  private final double interval;

  /**
   * Reads a recording.
   *
   * @param files one or more, with their formats
   * @param projection converts degrees to metres
   * @throws org.hificamsim.core.InputException if a file or a setting of the recording is wrong
   */
  public TracksImport(
      List<FormatChoice> files, Optional<Homography> homography, LocalProjection projection) {
    this.files = List.copyOf(files);
    recorded =
        FileTargets.together(
            files.stream()
                .map(file -> Collector.read(file, unit -> Ground.of(unit, homography, projection)))
                .toList());
    firstTick = recorded.firstTick();
    interval = Math.max(TIME_TOLERANCE, Math.rint(recorded.interval() * 1e6) / 1e6);
  }

  /**
   * Returns what the tracks are like.
   *
   * @param obstacles the summary reports tracks that pass through them
   * @throws org.hificamsim.core.InputException if the settings leave no samples of the recording
   */
  public ImportSummary summary(TrackSettings settings, Obstacles obstacles) {
    ImportSummary summary = new ImportSummary(recorded, interval, gap(settings), obstacles);
    for (RecordedTarget target : recorded.targets()) {
      summary.add(target.name(), tracks(target, settings));
    }
    if (summary.samples() == 0) {
      throw files
          .get(0)
          .recording()
          .missing("samples of targets; what is cut from the recording has none");
    }
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
    boolean keepsNames = recorded.haveNumericNames();
    int count = 0;
    try (Writer out = folder.open(name)) {
      TrackWriter writer = new TrackWriter(out, interval, TIME_TOLERANCE);
      for (RecordedTarget target : recorded.targets()) {
        count++;
        double number = keepsNames ? Double.parseDouble(target.name()) : count;
        Optional<Extent> extent = target.extent().or(settings::extent);
        write(writer, number, extent, settings.size(), tracks(target, settings));
      }
    }
  }

  private List<List<Sample>> tracks(RecordedTarget target, TrackSettings settings) {
    return target.tracks(firstTick, recorded.secondsPerTick(), settings, gap(settings));
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
}
