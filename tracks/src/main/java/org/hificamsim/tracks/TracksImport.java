package org.hificamsim.tracks;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.TrackWriter;
import org.hificamsim.tracks.Collector.TargetRecord;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.TrackFormat;
import org.hificamsim.tracks.ground.Ground;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * A recording of any size, read once and checked, its samples stored by target, to be written as a
 * file of tracks. Memory grows with the number of targets, not with that of samples.
 */
public final class TracksImport implements Closeable {
  /** Seconds a sample may be off the interval and be put there. */
  private static final double SLACK = 1e-6;

  private final Recording recording;
  private final SampleStore store = new SampleStore();
  private final Collector collector;
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
    collector = new Collector(store, unit -> Ground.of(unit, homography, projection));
    try {
      secondsPerTick = format.read(recording, collector).secondsPerTick(collector.spacing());
      requireSome(!collector.targets().isEmpty());
    } catch (RuntimeException e) {
      close();
      throw e;
    }
  }

  /**
   * Writes the tracks. A scenario knows the targets by their own names where all are whole numbers,
   * else as 1, 2, 3 in the order of appearance.
   *
   * @param obstacles through which nobody should go
   * @param folder receives the tracks under this name
   * @throws org.hificamsim.core.InputException when nothing is left of the recording
   */
  public ImportSummary write(
      TrackSettings settings, Obstacles obstacles, OutputFolder folder, String name)
      throws IOException {
    double interval = Math.max(SLACK, Math.rint(collector.spacing() * secondsPerTick * 1e6) / 1e6);
    double gap = settings.gap().orElse(3 * interval);
    ImportSummary summary = new ImportSummary(collector, interval, gap, obstacles);
    boolean ownNames = collector.ownNames();
    try (Writer out = folder.open(name)) {
      TrackWriter writer = new TrackWriter(out, interval, SLACK);
      for (TargetRecord target : collector.targets()) {
        double number = ownNames ? Double.parseDouble(target.name()) : target.number() + 1;
        TrackMaker maker = new TrackMaker(settings, writer, target, number, summary);
        store.each(
            target.number(),
            (tick, x, y) -> maker.sample((tick - collector.firstTick()) * secondsPerTick, x, y));
        maker.end();
      }
    }
    requireSome(summary.samples() > 0);
    return summary;
  }

  private void requireSome(boolean some) {
    if (!some) {
      throw recording.missing("samples of targets; the file, or what is cut from it, has none");
    }
  }

  @Override
  public void close() throws IOException {
    store.close();
  }
}
