package org.hificamsim.core.scenario.spec;

/** Whether targets hide each other, in addition to obstacles. */
public enum Occlusion {
  /** Targets do not hide each other. */
  NONE,
  /** A target hides those behind it, as a disc of its width. */
  TARGETS
}
