package org.hificamsim.presentation.picture;

import java.io.IOException;
import java.io.OutputStream;
import org.hificamsim.presentation.plot.FigureFile;

/**
 * An animation of a run.
 *
 * @param first the index of the first frame
 * @param last the index of the last frame, not before the first
 * @param every the number of frames from one picture to the next, 1 or more; the last frame is
 *     always shown
 */
public record Animation(RunFrames run, int first, int last, int every) {
  private static final int DEFAULT_MAX_PICTURES = 200;

  /** Returns an animation of at most 200 pictures. */
  public static Animation of(RunFrames run, int first, int last) {
    return new Animation(run, first, last, (last - first) / DEFAULT_MAX_PICTURES + 1);
  }

  /** The number of pictures. */
  public int pictures() {
    return (last - first + every - 1) / every + 1;
  }

  /** The number of steps from one picture to the next. */
  public long stepsApart() {
    return every * run.stepsApart();
  }

  /**
   * Writes the animation as GIF.
   *
   * @param width the width in pixels
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
