package org.hificamsim.core.visibility;

import org.hificamsim.core.Draw;

/**
 * What chance holds for each camera, target and step of a run: a {@link Draw} by its seed and these
 * three numbers, so that two policies on one seed meet the same luck.
 *
 * <p>With a memory of N a pair of camera and target keeps its luck for N steps, and then draws
 * again; pairs draw at different steps.
 */
final class Luck {
  private final long start;
  private final int memory;

  /**
   * @param memory steps, 1 or more
   */
  Luck(long seed, int memory) {
    this.start = Draw.key(seed, 1);
    this.memory = memory;
  }

  /** A number in [0, 1), uniform over steps and pairs. */
  double draw(long step, int camera, int target) {
    long pair = Draw.key(start, ((long) camera << 32) ^ (target & 0xFFFFFFFFL));
    long count = memory == 1 ? step : (step + Long.remainderUnsigned(pair, memory)) / memory;
    return Draw.unit(Draw.key(pair, count + 1));
  }
}
