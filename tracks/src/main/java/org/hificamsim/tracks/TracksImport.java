package org.hificamsim.tracks;

import java.io.IOException;
import java.io.Writer;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.TrackWriter;
import org.hificamsim.tracks.format.Clock;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.TrackFormat;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Ground;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * Reads a recording of any size and writes it as a file of tracks.
 *
 * <p>Two passes: the file is read once, its samples sorted by target; then they are written. Memory
 * grows with the number of targets, not with that of samples.
 */
public final class TracksImport {
  /** Seconds a sample may be off the interval and be put there. */
  private static final double SLACK = 1e-6;

  private final Recording recording;
  private final TrackSettings settings;
  private final Optional<Homography> homography;
  private final LocalProjection projection;

  /**
   * @param projection of degrees
   */
  public TracksImport(
      Recording recording,
      TrackSettings settings,
      Optional<Homography> homography,
      LocalProjection projection) {
    this.recording = recording;
    this.settings = settings;
    this.homography = homography;
    this.projection = projection;
  }

  /**
   * Imports the recording.
   *
   * @param obstacles through which nobody should go
   * @param folder receives the tracks under this name
   * @throws org.hificamsim.core.InputException when the file, or what is said of it, is wrong
   */
  public ImportSummary run(
      TrackFormat format, Obstacles obstacles, OutputFolder folder, String name)
      throws IOException {
    try (SampleSorter sorter = new SampleSorter()) {
      Collector collector = new Collector(sorter, this::ground);
      Clock clock = format.read(recording, collector);
      double secondsPerTick = clock.secondsPerTick(collector.spacing());
      double interval = rounded(collector.spacing() * secondsPerTick);
      Findings findings = new Findings(interval, obstacles);
      TargetNames names = new TargetNames(collector.targets());
      double gap;
      try (Writer out = folder.open(name)) {
        TrackWriter writer = new TrackWriter(out, interval, SLACK);
        TrackMaker maker = new TrackMaker(settings, writer, collector.targets(), names, findings);
        maker.write(sorter.sorted(), collector.firstTick(), secondsPerTick);
        gap = maker.gap();
      }
      requireSome(findings);
      return ImportSummary.of(collector, findings, names, gap);
    }
  }

  private Ground ground(Unit unit) {
    return Ground.of(unit, homography, projection);
  }

  private static double rounded(double seconds) {
    return Math.max(SLACK, Math.rint(seconds * 1e6) / 1e6);
  }

  private void requireSome(Findings findings) {
    if (findings.samples() == 0) {
      throw recording.missing("samples of targets; the file, or what is cut from it, has none");
    }
  }
}
