package org.hificamsim.agents.optimal;

/** What decides between configurations with the same k_min, camera by camera. */
public enum Preference {
  MOST_TARGETS_THEN_NARROWEST(true, false),
  MOST_TARGETS_THEN_WIDEST(true, true),
  NARROWEST(false, false),
  WIDEST(false, true);

  private final boolean mostTargets;
  private final boolean widest;

  Preference(boolean mostTargets, boolean widest) {
    this.mostTargets = mostTargets;
    this.widest = widest;
  }

  /** Whether a view that detects more targets comes first, before its width counts. */
  boolean mostTargets() {
    return mostTargets;
  }

  /** Whether the wider of two views comes first. */
  boolean widest() {
    return widest;
  }
}
