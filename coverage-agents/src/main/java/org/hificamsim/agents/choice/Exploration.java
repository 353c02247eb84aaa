package org.hificamsim.agents.choice;

import java.util.SplittableRandom;

/** What exploring draws from, uniformly; the thesis leaves it open. */
public enum Exploration {
  /** Every level but the best one. */
  OTHER,
  /** Every level, the best one included. */
  ANY;

  /**
   * Draws a level in [0, {@code levels}); the best one where there is no other.
   *
   * @param best the level that exploiting would take
   */
  public int draw(SplittableRandom random, int levels, int best) {
    if (this == ANY) {
      return random.nextInt(levels);
    }
    if (levels == 1) {
      return best;
    }
    int drawn = random.nextInt(levels - 1);
    return drawn < best ? drawn : drawn + 1;
  }
}
