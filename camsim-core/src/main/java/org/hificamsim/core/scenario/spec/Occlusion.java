package org.hificamsim.core.scenario.spec;

/** What hides a target in addition to obstacles. */
public enum Occlusion {
  /** Nothing. */
  NONE,
  /** Other targets: a disc as wide as the target, between it and the camera. */
  TARGETS
}
