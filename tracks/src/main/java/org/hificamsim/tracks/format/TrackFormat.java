package org.hificamsim.tracks.format;

/**
 * A format of recorded tracks. An implementation reads a file once from start to end, and stores
 * nothing. Samples may be in any order. A new instance is made for each file.
 */
public interface TrackFormat {
  /** Says whether a file looks like this format, and why. */
  FormatFit fit(FileStart start, Recording recording);

  /**
   * Reads a file.
   *
   * @param samples receives the unit, then each sample, and the rows that are left out
   * @return the unit of time
   * @throws org.hificamsim.core.InputException with the place, if the file is wrong
   */
  Clock read(Recording recording, SampleSink samples);

  /** The unit of positions if neither the user nor the file gives one. */
  default Unit usualUnit() {
    return Unit.M;
  }

  /**
   * Whether names of targets are from the file, so that other files may have the same targets;
   * known after reading.
   */
  default boolean hasIds() {
    return true;
  }

  /** Whether a name belongs to another target where time goes back. */
  default boolean reusesIds() {
    return false;
  }

  /** Whether users may name the columns or properties of a file. */
  default boolean namesColumns() {
    return false;
  }
}
