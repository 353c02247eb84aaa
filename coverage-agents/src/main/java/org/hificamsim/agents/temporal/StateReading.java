package org.hificamsim.agents.temporal;

/** What a camera takes for its state; section 7.4.4 says no more than that it is the percept. */
public enum StateReading {
  /** The current level and the number of targets detected with it. */
  LEVEL_COUNT,
  /** The number of targets detected. */
  COUNT,
  /** Always the same state: what is learned is one value for each level. */
  NONE;

  /** The number of states of a camera with that many levels where that many targets can exist. */
  long states(int levels, int targets) {
    return switch (this) {
      case LEVEL_COUNT -> levels * (targets + 1L);
      case COUNT -> targets + 1L;
      case NONE -> 1;
    };
  }

  /** The number of a state, from 0: the same for all cameras, however many levels they have. */
  int state(int level, int detected, int targets) {
    return switch (this) {
      case LEVEL_COUNT -> level * (targets + 1) + detected;
      case COUNT -> detected;
      case NONE -> 0;
    };
  }
}
