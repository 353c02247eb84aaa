package org.hificamsim.core.visibility;

/**
 * What chance holds for each camera, target and step of a run: a hash of its seed and of these
 * three numbers, so that it depends on no order, thread or policy. Two policies on one seed meet
 * the same luck.
 *
 * <p>The hash is SplitMix64 (Steele, Lea and Flood, OOPSLA 2014) with a start of its own for each
 * pair of camera and target, and the step for a counter. With a memory of N a pair keeps its luck
 * for N steps, and then draws again; pairs draw at different steps.
 */
final class Luck {
  private static final long GAMMA = 0x9E3779B97F4A7C15L;
  private static final double UNIT = 0x1p-53;

  private final long start;
  private final int memory;

  /**
   * @param memory steps, 1 or more
   */
  Luck(long seed, int memory) {
    this.start = mix(seed + GAMMA);
    this.memory = memory;
  }

  /** A number in [0, 1), uniform over steps and pairs. */
  double draw(long step, int camera, int target) {
    long pair = mix(start + GAMMA * (((long) camera << 32) ^ (target & 0xFFFFFFFFL)));
    long count = memory == 1 ? step : (step + Long.remainderUnsigned(pair, memory)) / memory;
    return (mix(pair + GAMMA * (count + 1)) >>> 11) * UNIT;
  }

  /** Stafford's variant 13 of the mixing function of MurmurHash3. */
  private static long mix(long z) {
    long y = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    y = (y ^ (y >>> 27)) * 0x94D049BB133111EBL;
    return y ^ (y >>> 31);
  }
}
