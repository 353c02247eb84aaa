package org.hificamsim.bridge.camsim;

/** What the bridge may be asked to do with CamSim; each takes some of its methods. */
public enum Use {
  /** Read cameras and objects, in any case. */
  READ,
  /** Decide what cameras see. */
  DETECT,
  /** Set what cameras look at. */
  STEER,
  /** Write files. */
  RECORD,
  /** Have objects follow tracks. */
  TRACK,
  /** Tell objects apart by their features. */
  NAME
}
