package org.hificamsim.bridge.run;

import org.hificamsim.bridge.camsim.CamSim;

/** An object of CamSim's as it was at the last {@link #refresh}. */
final class LiveTarget {
  /** A target that is yet to come. */
  static final LiveTarget TO_COME = new LiveTarget(null, "");

  private final Object handle;
  final String name;
  boolean present;
  double x;
  double y;
  int coverage; // how many cameras see it

  LiveTarget(Object handle, String name) {
    this.handle = handle;
    this.name = name;
  }

  /** Looks whether the object is in the world, and where. */
  void refresh(CamSim camsim, boolean inTheWorld) {
    present = inTheWorld;
    if (present) {
      x = camsim.objectX(handle);
      y = camsim.objectY(handle);
    }
  }
}
