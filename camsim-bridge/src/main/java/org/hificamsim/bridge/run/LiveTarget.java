package org.hificamsim.bridge.run;

import org.hificamsim.bridge.camsim.CamSim;

/** An object of CamSim's as it was at the last {@link #refresh}. */
final class LiveTarget {
  /** A target that is yet to come. */
  static final LiveTarget TO_COME = new LiveTarget(null, "");

  private final Object handle;
  private final String name;
  private boolean present;
  private double x;
  private double y;
  private int coverage;

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

  /** No camera sees it. */
  void uncover() {
    coverage = 0;
  }

  /** One more camera sees it, or, by -1, one less. */
  void cover(int cameras) {
    coverage += cameras;
  }

  String name() {
    return name;
  }

  boolean present() {
    return present;
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  int coverage() {
    return coverage;
  }
}
