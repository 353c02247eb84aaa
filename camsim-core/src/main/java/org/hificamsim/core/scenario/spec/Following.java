package org.hificamsim.core.scenario.spec;

/** Whether a run measures how cameras follow targets: the attribute {@code following}. */
public enum Following {
  NONE,
  /** Follows when each target is found, lost and handed over ({@code docs/following.md}). */
  TARGETS
}
