package org.hificamsim.core.scenario.spec;

/** Whether an upright target looks shorter from above. */
public enum Foreshortening {
  /** It looks as high as a target at that distance that faces the camera. */
  NONE,
  /** It looks shorter by the cosine of the angle of depression. */
  COSINE
}
