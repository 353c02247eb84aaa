package org.hificamsim.tracks;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.TrackWriter;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.TrackFormat;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Ground;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * A recording of any size, read once and checked, its samples sorted by target, to be written as a
 * file of tracks. Memory grows with the number of targets, not with that of samples.
 */
public final class TracksImport implements Closeable {
  /** Seconds a sample may be off the interval and be put there. */
  private static final double SLACK = 1e-6;

  private final Recording recording;
  private final Optional<Homography> homography;
  private final LocalProjection projection;
  private final SampleSorter sorter = new SampleSorter();
  private final Collector collector = new Collector(sorter, this::ground);
  private double secondsPerTick;

  /**
   * Reads a recording.
   *
   * @param projection of degrees
   * @throws org.hificamsim.core.InputException when the file, or what is said of it, is wrong
   */
  public TracksImport(
      TrackFormat format,
      Recording recording,
      Optional<Homography> homography,
      LocalProjection projection)
      throws IOException {
    this.recording = recording;
    this.homography = homography;
    this.projection = projection;
    try {
      secondsPerTick = format.read(recording, collector).secondsPerTick(collector.spacing());
      requireSome(collector.samples());
    } catch (RuntimeException e) {
      close();
      throw e;
    }
  }

  /**
   * Writes the tracks.
   *
   * @param obstacles through which nobody should go
   * @param folder receives the tracks under this name
   * @throws org.hificamsim.core.InputException when nothing is left of the recording
   */
  public ImportSummary write(
      TrackSettings settings, Obstacles obstacles, OutputFolder folder, String name)
      throws IOException {
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
    requireSome(findings.samples());
    return ImportSummary.of(collector, findings, names, gap);
  }

  private Ground ground(Unit unit) {
    return Ground.of(unit, homography, projection);
  }

  private static double rounded(double seconds) {
    return Math.max(SLACK, Math.rint(seconds * 1e6) / 1e6);
  }

  private void requireSome(long samples) {
    if (samples == 0) {
      throw recording.missing("samples of targets; the file, or what is cut from it, has none");
    }
  }

  @Override
  public void close() throws IOException {
    sorter.close();
  }
}
