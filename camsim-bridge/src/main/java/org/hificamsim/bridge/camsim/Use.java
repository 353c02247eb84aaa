package org.hificamsim.bridge.camsim;

/** The ways in which the bridge uses CamSim; each needs some of its methods. */
public enum Use {
  /** Read cameras and objects; always needed. */
  READ,
  /** Decide what cameras see. */
  DETECT,
  /** Set what cameras look at. */
  STEER,
  /** Write files. */
  RECORD,
  /** Move objects along tracks. */
  TRACK,
  /** Identify objects by their features. */
  NAME
}
