package org.hificamsim.tracks.format;

import java.util.function.DoubleSupplier;

/**
 * The unit of time of a format.
 *
 * @param rate ticks per second, above 0
 * @param countsSamples whether the rate is the number of a target's samples per second, whatever
 *     the number of ticks between them
 */
public record Clock(double rate, boolean countsSamples) {
  /** The clock whose ticks are seconds. */
  public static final Clock SECONDS = new Clock(1, false);

  /** Whether ticks are frames, which have whole numbers. */
  public boolean countsFrames() {
    return rate != SECONDS.rate;
  }

  /**
   * Returns the length of a tick in seconds.
   *
   * @param spacing returns the number of ticks between samples of a target
   */
  public double secondsPerTick(DoubleSupplier spacing) {
    return countsSamples ? 1 / (rate * spacing.getAsDouble()) : 1 / rate;
  }
}
