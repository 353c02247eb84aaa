package org.hificamsim.tracks;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
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
  /** The tolerance within which a sample's time is rounded to the interval, in seconds. */
  private static final double TIME_TOLERANCE = 1e-6;

  private final List<FormatChoice> files;
  private final RecordedTargets recorded;
  private final double firstTick;

  /** The usual time between two samples of a target, in seconds. */
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
        FileTargets.combine(
            files.stream()
                .map(file -> Collector.read(file, unit -> Ground.of(unit, homography, projection)))
                .toList());
    firstTick = recorded.firstTick();
    interval = Math.max(TIME_TOLERANCE, Math.rint(recorded.interval() * 1e6) / 1e6);
  }

  /**
   * Writes the tracks. Targets keep their names if all are whole numbers, otherwise they become 1,
   * 2, 3, ... in the order of their first samples.
   *
   * @param obstacles obstacles; the summary reports tracks that pass through them
   * @param out receives the text of the file
   * @return the findings about the tracks
   * @throws org.hificamsim.core.InputException if the settings leave no samples of the recording
   */
  public ImportSummary write(TrackSettings settings, Obstacles obstacles, Appendable out)
      throws IOException {
    double gap = settings.gap().orElse(3 * interval);
    ImportSummary summary = new ImportSummary(recorded, interval, gap, obstacles);
    boolean keepsNames = recorded.haveNumericNames();
    int count = 0;
    TrackWriter writer = new TrackWriter(out, interval, TIME_TOLERANCE);
    for (RecordedTarget target : recorded.targets()) {
      count++;
      double number = keepsNames ? Double.parseDouble(target.name()) : count;
      Optional<Extent> extent = target.extent().or(settings::extent);
      List<List<Sample>> tracks =
          target.tracks(firstTick, recorded.secondsPerTick(), settings, gap);
      write(writer, number, extent, settings.size(), tracks);
      summary.add(target.name(), tracks);
    }
    requireSamples(summary);
    return summary;
  }

  private void requireSamples(ImportSummary summary) {
    if (summary.samples() == 0) {
      throw files
          .get(0)
          .recording()
          .missing("samples of targets; what is cut from the recording has none");
    }
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
