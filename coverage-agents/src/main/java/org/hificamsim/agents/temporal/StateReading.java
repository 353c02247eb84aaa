package org.hificamsim.agents.temporal;

/** What a camera takes as its state; thesis 7.4.4 says only that it is the percept. */
public enum StateReading {
  /** The current view and the number of targets detected with it. */
  LEVEL_COUNT,
  /** The number of targets detected. */
  COUNT,
  /** Always the same state: what is learned is one value for each view. */
  NONE;

  /** How many different numbers of detected targets there are where so many targets can exist. */
  int counts(int targets) {
    return this == NONE ? 1 : targets + 1;
  }

  /** The number of states of a camera with so many views that share a number of targets. */
  int statesPerCount(int views) {
    return this == LEVEL_COUNT ? views : 1;
  }

  /** The number of a state, from 0: those with fewer targets come first. */
  int state(int view, int detected, int views) {
    return switch (this) {
      case LEVEL_COUNT -> detected * views + view;
      case COUNT -> detected;
      case NONE -> 0;
    };
  }
}
