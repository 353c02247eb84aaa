package org.hificamsim.core.scenario.spec;

import java.util.Collections;
import java.util.List;

/**
 * The relation between the opening angle of a camera's view and its reach. Readers, worlds and
 * commands ask a law for its properties, so that none of them knows a law by its name.
 */
public enum OpticsLaw {
  /**
   * The camera's own opening angle at every level, and the radii of the zoom list, or its range.
   */
  ROUND(0, false) {
    @Override
    public List<Double> radii(List<Double> angles, double reach) {
      return List.of();
    }
  },
  /** The sector's area is the same at every level: reach times sqrt(narrowest angle / angle). */
  CONSTANT_AREA(180, true) {
    @Override
    public List<Double> radii(List<Double> angles, double reach) {
      return angles.stream().map(angle -> reach * Math.sqrt(angles.get(0) / angle)).toList();
    }
  },
  /** A lens: it reaches as far as the detection model does, or as the optics say. */
  PINHOLE(Math.nextDown(180.0), false) {
    @Override
    public List<Double> radii(List<Double> angles, double reach) {
      return Collections.nCopies(angles.size(), reach);
    }
  };

  private final double widest;
  private final boolean needsReach;

  OpticsLaw(double widest, boolean needsReach) {
    this.widest = widest;
    this.needsReach = needsReach;
  }

  /** Whether each level has an angle of view of its own, as lenses have. */
  public boolean hasAngles() {
    return widest > 0;
  }

  /** The widest angle of view that a level may have, in degrees; 0 if levels have none. */
  public double widest() {
    return widest;
  }

  /** Whether scenario files must give the reach of such optics. */
  public boolean needsReach() {
    return needsReach;
  }

  /**
   * Returns the reach of each level, in metres.
   *
   * @param angles the angles of view, in degrees, from the narrowest
   * @param reach the reach of the optics, in metres
   */
  public abstract List<Double> radii(List<Double> angles, double reach);
}
