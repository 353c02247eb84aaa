package org.hificamsim.presentation.replay;

/**
 * How much of a run is kept.
 *
 * @param frames most frames
 * @param numbers most numbers in all frames together
 * @param bytes most bytes of all runs together, packed, and of the setup; frames are left out for
 *     it down to the first and the last one, whatever the cameras' poses take
 */
record RecordingLimits(int frames, long numbers, int bytes) {
  /** A page of less than 5 MB, the memory of a small machine. */
  static final RecordingLimits USUAL = new RecordingLimits(20_000, 1 << 23, 4_400_000);

  /**
   * What is left for the runs: nothing beside a large setup, so that one run is kept, of two
   * frames.
   */
  RecordingLimits beside(Setup setup) {
    int left = Math.max(0, bytes - ReplayJson.of(setup).length());
    return new RecordingLimits(frames, numbers, left);
  }

  /** The most frames of one run, 2 or more. */
  int frames(Setup setup) {
    return (int) Math.max(2, Math.min(frames, numbers / (1 + setup.numbersPerFrame())));
  }
}
