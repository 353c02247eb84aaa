package org.hificamsim.core.scenario.spec;

/** Whether a camera sees on its way from one view to another. */
public enum Moving {
  /** It sees nothing until it has arrived. */
  BLIND,
  /** It sees as through the view that it passes: the nearest one in pan and zoom. */
  SEES
}
