package org.hificamsim.bench.plain;

/** Chooses the zoom level of one camera. Level 0 is the narrowest. */
interface LevelPolicy {
  /** Returns the next level, given the present one and how many targets it detected. */
  int choose(int level, int detected);

  /** Learns from the number of targets that a level detected. */
  default void learn(int level, int detected) {}
}
