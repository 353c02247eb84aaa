package org.hificamsim.core.visibility;

import org.hificamsim.core.Draw;

/**
 * The luck of each camera with each target in each step of a run: a {@link Draw} by the seed and
 * these three numbers, so that all policies meet the same luck on one seed.
 *
 * <p>With a memory of N, a pair of camera and target keeps its luck for N steps and then draws
 * again; different pairs draw at different steps.
 */
final class Luck {
  private final long start;
  private final int memory;

  /**
   * @param memory the memory, steps, 1 or more
   */
  Luck(long seed, int memory) {
    this.start = Draw.key(seed, 1);
    this.memory = memory;
  }

  /** Returns the luck in [0, 1), uniform over steps and pairs. */
  double draw(long step, int camera, int target) {
    long pair = Draw.key(start, ((long) camera << 32) ^ (target & 0xFFFFFFFFL));
    long count = memory == 1 ? step : (step + Long.remainderUnsigned(pair, memory)) / memory;
    return Draw.unit(Draw.key(pair, count + 1));
  }
}
