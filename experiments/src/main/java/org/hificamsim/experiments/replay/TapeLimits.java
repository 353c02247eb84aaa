package org.hificamsim.experiments.replay;

/**
 * How much of a run is kept.
 *
 * @param frames most frames
 * @param numbers most numbers in all frames together
 * @param bytes most bytes of all runs together, packed
 */
record TapeLimits(int frames, long numbers, int bytes) {
  /** A page of less than 5 MB, the memory of a small machine. */
  static final TapeLimits USUAL = new TapeLimits(20_000, 1 << 23, 4_400_000);

  /** The most frames of one run, 2 or more. */
  int frames(Setup setup) {
    long numbersPerFrame = 1 + 4L * setup.targets().size();
    for (CameraSetup camera : setup.cameras()) {
      numbersPerFrame += 3 + 2L * camera.pose().levels().size();
    }
    return (int) Math.max(2, Math.min(frames, numbers / numbersPerFrame));
  }
}
