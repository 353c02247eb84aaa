package org.hificamsim.python;

import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.presentation.picture.RunFrames;
import org.hificamsim.presentation.picture.StepPicture;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.replay.Snapshots;

/** Records the frames of an episode of a world, and paints them. */
final class EpisodePainter implements StepListener {
  private final Supplier<Setup> setups;
  private final Detection detection;
  private final List<Frame> frames = new ArrayList<>();
  private final List<Move> moves = new ArrayList<>();
  private Setup setup;
  private Snapshots snapshots;

  /**
   * @param setups returns the setup of the episode that begins
   */
  EpisodePainter(Supplier<Setup> setups, Detection detection) {
    this.setups = setups;
    this.detection = detection;
  }

  @Override
  public void started(OracleView network, ZoomPolicy policy) {
    frames.clear();
    moves.clear();
    setup = setups.get();
    snapshots = new Snapshots(setup, detection, policy);
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    moves.addAll(snapshots.moves(network));
    frames.add(snapshots.take(network));
  }

  /**
   * Paints the last step, or the current network before the first step.
   *
   * @param width the width of the picture, in pixels
   * @return width and height as two ints, then red, green and blue of each pixel, row by row
   */
  byte[] picture(OracleView network, long seed, int width) {
    List<Frame> shown = frames.isEmpty() ? List.of(snapshots.take(network)) : List.copyOf(frames);
    long steps = shown.get(shown.size() - 1).step() + 1;
    RecordedRun recording = new RecordedRun(0, seed, steps, 1, "", List.copyOf(moves), shown);
    RunFrames run = new RunFrames(setup, recording);
    return bytes(FigureFile.image(new StepPicture(run, shown.size() - 1), width));
  }

  private static byte[] bytes(BufferedImage image) {
    int width = image.getWidth();
    int[] pixels = image.getRGB(0, 0, width, image.getHeight(), null, 0, width);
    ByteBuffer bytes = ByteBuffer.allocate(2 * Integer.BYTES + 3 * pixels.length);
    bytes.putInt(width).putInt(image.getHeight());
    for (int pixel : pixels) {
      bytes.put((byte) (pixel >> 16)).put((byte) (pixel >> 8)).put((byte) pixel);
    }
    return bytes.array();
  }
}
