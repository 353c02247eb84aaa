package org.hificamsim.core.scenario.spec;

/** Whether targets hide each other, in addition to obstacles. */
public enum Occlusion {
  /** Nothing. */
  NONE,
  /** Other targets: a disc as wide as the target, between it and the camera. */
  TARGETS
}
