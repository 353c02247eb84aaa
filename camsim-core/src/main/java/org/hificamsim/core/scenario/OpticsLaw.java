package org.hificamsim.core.scenario;

/** What ties the opening angle of a camera's view to how far it reaches. */
public enum OpticsLaw {
  /**
   * The camera's own opening angle at every level, and the radii of the zoom list, or its range.
   */
  ROUND,
  /** The sector's area is the same at every level: reach times sqrt(narrowest angle / angle). */
  CONSTANT_AREA,
  /** A lens: it reaches as far as the detection model does, or as the optics say. */
  PINHOLE
}
