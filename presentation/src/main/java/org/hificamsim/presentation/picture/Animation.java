package org.hificamsim.presentation.picture;

import java.io.IOException;
import java.io.OutputStream;
import org.hificamsim.presentation.plot.FigureFile;

/**
 * A run in pictures that follow each other.
 *
 * @param first frame
 * @param last frame, not before the first
 * @param every how many frames one picture stands for, 1 or more; the last frame is always shown
 */
public record Animation(RunFrames run, int first, int last, int every) {
  private static final int MAX_BY_ITSELF = 200;

  /** An animation of no more than 200 pictures. */
  public static Animation of(RunFrames run, int first, int last) {
    return new Animation(run, first, last, (last - first) / MAX_BY_ITSELF + 1);
  }

  /** How many pictures there are. */
  public int pictures() {
    return (last - first + every - 1) / every + 1;
  }

  /** How many steps lie between two pictures. */
  public long stepsApart() {
    return every * run.stepsApart();
  }

  /**
   * Writes it as GIF.
   *
   * @param width pixels
   * @param perSecond pictures per second, 1 to 50
   */
  public void write(OutputStream out, int width, int perSecond) throws IOException {
    GifFile.write(
        out,
        pictures(),
        i -> FigureFile.image(new StepPicture(run, Math.min(first + i * every, last)), width),
        Math.round(100f / perSecond));
  }
}
