package org.hificamsim.presentation.view;

import org.hificamsim.presentation.replay.Setup;

/** How many steps are kept, so that large scenarios need no more memory than small ones. */
final class HistoryLimit {
  private static final int MAX_STEPS = 4000;
  private static final int MIN_STEPS = 50;
  private static final long MAX_NUMBERS = 1 << 21;

  private HistoryLimit() {}

  /** The steps that are kept of a scenario. */
  static int steps(Setup setup) {
    long numbers = setup.numbersPerFrame();
    return (int) Math.max(MIN_STEPS, Math.min(MAX_STEPS, MAX_NUMBERS / Math.max(1, numbers)));
  }
}
