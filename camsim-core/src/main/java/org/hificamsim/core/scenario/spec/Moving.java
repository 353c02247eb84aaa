package org.hificamsim.core.scenario.spec;

/** What a camera sees on its way from one view to another. */
public enum Moving {
  /** Nothing, until it has arrived. */
  BLIND,
  /** What the view sees that it passes: the nearest one in pan and zoom. */
  SEES
}
