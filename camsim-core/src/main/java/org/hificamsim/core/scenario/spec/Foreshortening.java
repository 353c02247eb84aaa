package org.hificamsim.core.scenario.spec;

/** Whether an upright target looks shorter from above. */
public enum Foreshortening {
  /** A target looks as high as if it faced the camera at the same distance. */
  NONE,
  /** A target looks shorter by the cosine of the angle of depression. */
  COSINE
}
