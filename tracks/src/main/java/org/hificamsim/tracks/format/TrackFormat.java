package org.hificamsim.tracks.format;

/**
 * A format of recorded tracks. An implementer reads a file once from front to back, keeping
 * nothing; samples of a target come in order of time, those of different targets in any order.
 */
public interface TrackFormat {
  /**
   * Reads a file.
   *
   * @param samples takes the unit, then each sample
   * @return how the format counts time
   * @throws org.hificamsim.core.InputException with the place, when something is wrong
   */
  Clock read(Recording recording, SampleSink samples);
}
