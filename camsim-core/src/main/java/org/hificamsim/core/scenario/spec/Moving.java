package org.hificamsim.core.scenario.spec;

/** Whether a camera sees on its way from one view to another. */
public enum Moving {
  /** The camera sees nothing until it has arrived. */
  BLIND,
  /** The camera sees as if it had the nearest view in pan and zoom. */
  SEES
}
