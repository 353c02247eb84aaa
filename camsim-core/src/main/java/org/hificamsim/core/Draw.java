package org.hificamsim.core;

/**
 * Numbers drawn by what they are for, and not one after the other: hashes of a seed and of counters
 * such as a step and a camera, so that a draw depends on no order, thread or policy.
 *
 * <p>The hash is SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): a key for each counter, from the
 * key before.
 */
public final class Draw {
  private static final long GAMMA = 0x9E3779B97F4A7C15L;
  private static final double UNIT = 0x1p-53;

  private Draw() {}

  /** The key of a counter after those that {@code key} stands for; at first that is the seed. */
  public static long key(long key, long counter) {
    return mix(key + GAMMA * counter);
  }

  /** The number in [0, 1) of a key. */
  public static double unit(long key) {
    return (key >>> 11) * UNIT;
  }

  /** Stafford's variant 13 of the mixing function of MurmurHash3. */
  private static long mix(long z) {
    long y = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    y = (y ^ (y >>> 27)) * 0x94D049BB133111EBL;
    return y ^ (y >>> 31);
  }
}
