package org.hificamsim.presentation.view;

import org.hificamsim.presentation.replay.Setup;

/** How many steps are kept, so that large scenarios need no more memory than small ones. */
final class Memory {
  private static final int MOST_STEPS = 4000;
  private static final int LEAST_STEPS = 50;
  private static final long MOST_NUMBERS = 1 << 21;

  private Memory() {}

  /** The steps that are kept of a scenario. */
  static int steps(Setup setup) {
    long numbers = setup.numbersPerFrame();
    return (int) Math.max(LEAST_STEPS, Math.min(MOST_STEPS, MOST_NUMBERS / Math.max(1, numbers)));
  }
}
