package org.hificamsim.core.scenario.spec;

/** Whether an upright target looks shorter from above. */
public enum Foreshortening {
  /** It is as high in the picture as one at that distance that faces the camera. */
  NONE,
  /** By the cosine of the angle of depression. */
  COSINE
}
