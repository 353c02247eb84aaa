package org.hificamsim.core.scenario.file;

import java.io.IOException;
import org.hificamsim.core.scenario.spec.Extent;

/**
 * Writes tracks as {@code docs/tracks.md} describes the file, one target after the other; a target
 * that went and came again is begun again.
 */
public final class TrackWriter {
  /** What the file begins with. */
  static final String HEADER = "tracks 1";

  private final Appendable out;
  private final double interval;
  private final double slack;
  private double begun;
  private int since;

  /**
   * Begins a file.
   *
   * @param interval between most samples, seconds, above 0; samples that keep it have no time
   * @param slack how far a sample may be off it, seconds, and be put there
   */
  public TrackWriter(Appendable out, double interval, double slack) throws IOException {
    this.out = out;
    this.interval = interval;
    this.slack = slack;
    out.append(HEADER).append("\ninterval ").append(plain(interval)).append('\n');
  }

  /** Begins a track of a target with one size, metres. */
  public void target(double features, double size) throws IOException {
    begin(features);
    out.append(" size ").append(plain(size)).append('\n');
  }

  /** Begins a track of a target with a width and a height. */
  public void target(double features, Extent extent) throws IOException {
    begin(features);
    out.append(" width ").append(plain(extent.width()));
    out.append(" height ").append(plain(extent.height())).append('\n');
  }

  private void begin(double features) throws IOException {
    out.append("target ").append(plain(features));
    begun = Double.NaN;
  }

  /** Adds a sample to the target's track: seconds, later than the one before, and metres. */
  public void sample(double time, double x, double y) throws IOException {
    since++;
    if (!(Math.abs(begun + since * interval - time) <= slack)) {
      out.append(plain(time)).append(' ');
      begun = time;
      since = 0;
    }
    out.append(plain(x)).append(' ').append(plain(y)).append('\n');
  }

  /** The shortest text of the same number. */
  static String plain(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e7 && (value != 0 || 1 / value > 0)
        ? Integer.toString((int) value)
        : Double.toString(value);
  }
}
