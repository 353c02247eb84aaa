package org.hificamsim.core;

/**
 * Counter-based random numbers: hashes of a seed and of counters such as step and camera, so that a
 * draw does not depend on order, thread or policy.
 *
 * <p>The hash is SplitMix64 (Steele, Lea and Flood, OOPSLA 2014); each counter derives a key from
 * the key before it.
 */
public final class Draw {
  private static final long GAMMA = 0x9E3779B97F4A7C15L;
  private static final double UNIT = 0x1p-53;

  private Draw() {}

  /** Derives a key from a key and a counter; the first key is the seed. */
  public static long key(long key, long counter) {
    return mix(key + GAMMA * counter);
  }

  /** Returns the number in [0, 1) of a key. */
  public static double unit(long key) {
    return (key >>> 11) * UNIT;
  }

  /** Mixes the bits of a number by Stafford's variant 13 of the function of MurmurHash3. */
  private static long mix(long z) {
    long y = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    y = (y ^ (y >>> 27)) * 0x94D049BB133111EBL;
    return y ^ (y >>> 31);
  }
}
