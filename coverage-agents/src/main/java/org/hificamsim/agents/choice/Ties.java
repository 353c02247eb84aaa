package org.hificamsim.agents.choice;

import org.hificamsim.core.registry.Options;

/** Which of several equally good levels a camera takes; the thesis does not say. */
public enum Ties {
  WIDEST,
  NARROWEST;

  /** The option {@code ties}. */
  public static Ties from(Options options, Ties defaultValue) {
    return options.choice("ties", defaultValue, "which of equally good levels: widest, narrowest");
  }

  /** The level to take of so many equally good ones. */
  public int best(int levels) {
    return this == WIDEST ? levels - 1 : 0;
  }

  /**
   * The level with the largest value.
   *
   * @param values holds the value of level l at {@code from + l}; infinite values are allowed, NaN
   *     is not
   * @param levels the number of levels, 1 or more
   */
  public int best(double[] values, int from, int levels) {
    int best = 0;
    double most = values[from];
    for (int level = 1; level < levels; level++) {
      double value = values[from + level];
      boolean better = value > most || (value == most && this == WIDEST);
      best = better ? level : best;
      most = better ? value : most;
    }
    return best;
  }
}
