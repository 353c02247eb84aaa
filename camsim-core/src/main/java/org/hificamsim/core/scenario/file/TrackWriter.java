package org.hificamsim.core.scenario.file;

import java.io.IOException;
import java.math.BigDecimal;
import org.hificamsim.core.scenario.spec.Extent;

/**
 * Writes tracks as {@code docs/tracks.md} describes the file, one target after the other; a target
 * that disappears and comes back has another track.
 */
public final class TrackWriter {
  /** The first line of the file. */
  static final String HEADER = "tracks 1";

  /** The least number that Java writes with an exponent. */
  private static final double FIRST_EXPONENT = 1e7;

  private static final double MAX_FAST = 1e9;
  private static final double ONE_OVER_MINUS_0 = Double.NEGATIVE_INFINITY;

  private final Appendable out;
  private final double interval;
  private final double slack;
  private double writtenTime;
  private int samplesSinceWrittenTime;

  /**
   * Begins a file.
   *
   * @param interval the time between most samples, in seconds, above 0; samples that keep it are
   *     written without their time
   * @param slack the greatest deviation from the interval that is ignored, in seconds
   */
  public TrackWriter(Appendable out, double interval, double slack) throws IOException {
    this.out = out;
    this.interval = interval;
    this.slack = slack;
    out.append(HEADER).append("\ninterval ").append(plain(interval)).append('\n');
  }

  /** Begins a track of a target with one size, in metres. */
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
    writtenTime = Double.NaN;
  }

  /**
   * Adds a sample to the target's track: its time in seconds, later than the previous one, and its
   * position in metres.
   */
  public void sample(double time, double x, double y) throws IOException {
    samplesSinceWrittenTime++;
    if (!(Math.abs(writtenTime + samplesSinceWrittenTime * interval - time) <= slack)) {
      out.append(plain(time)).append(' ');
      writtenTime = time;
      samplesSinceWrittenTime = 0;
    }
    out.append(plain(x)).append(' ').append(plain(y)).append('\n');
  }

  /** The shortest text of the same number, without an exponent if it is large. */
  static String plain(double value) {
    long thousandths = Math.round(value * 1000);
    if (Math.abs(value) < MAX_FAST && thousandths / 1e3 == value && 1 / value != ONE_OVER_MINUS_0) {
      return ofThousandths(thousandths);
    }
    return Math.abs(value) >= FIRST_EXPONENT && Double.isFinite(value)
        ? new BigDecimal(Double.toString(value)).toPlainString()
        : Double.toString(value);
  }

  /** The same as Java writes, in a third of the time: all positions are whole millimetres. */
  private static String ofThousandths(long thousandths) {
    long absolute = Math.abs(thousandths);
    StringBuilder text = new StringBuilder(thousandths < 0 ? "-" : "").append(absolute / 1000);
    long rest = absolute % 1000;
    if (rest > 0) {
      text.append('.').append((char) ('0' + rest / 100));
    }
    if (rest % 100 > 0) {
      text.append((char) ('0' + rest / 10 % 10));
    }
    if (rest % 10 > 0) {
      text.append((char) ('0' + rest % 10));
    }
    return text.toString();
  }
}
