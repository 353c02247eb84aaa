package org.hificamsim.core.scenario.spec;

/** What a camera sees on its way from one view to another. */
public enum Moving {
  /** Nothing, until it has arrived. */
  BLIND,
  /** What the view of its list sees that it is passing: the nearest in pan and in zoom. */
  SEES
}
