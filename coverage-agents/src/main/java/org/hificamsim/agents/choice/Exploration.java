package org.hificamsim.agents.choice;

import java.util.SplittableRandom;

/** What exploring draws from, uniformly; the thesis leaves it open. */
public enum Exploration {
  /** Every view but the best one. */
  OTHER,
  /** Every view, the best one included. */
  ANY;

  /**
   * Draws a view in [0, {@code views}); the best one where there is no other.
   *
   * @param best the view that exploiting would take
   */
  public int draw(SplittableRandom random, int views, int best) {
    if (this == ANY) {
      return random.nextInt(views);
    }
    if (views == 1) {
      return best;
    }
    int drawn = random.nextInt(views - 1);
    return drawn < best ? drawn : drawn + 1;
  }
}
