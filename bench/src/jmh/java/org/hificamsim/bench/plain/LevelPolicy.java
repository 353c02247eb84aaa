package org.hificamsim.bench.plain;

/** How one camera chooses its zoom level, 0 being the narrowest. */
interface LevelPolicy {
  /** The next level, given the present one and how many targets it detected. */
  int choose(int level, int detected);

  /** Takes note of what a level detected. */
  default void learn(int level, int detected) {}
}
