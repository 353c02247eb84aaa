package org.hificamsim.bridge.camsim;

/** The units in which a method of CamSim may take angles; it stores radians (behaviour 2). */
enum AngleUnit {
  DEGREES(360) {
    @Override
    double of(double radians) {
      double above = Math.toDegrees(radians);
      double below = above;
      for (int i = 0; i < ROUNDINGS; i++) {
        if (Math.toRadians(below) == radians) {
          return below;
        } else if (Math.toRadians(above) == radians) {
          return above;
        }
        below = Math.nextDown(below);
        above = Math.nextUp(above);
      }
      return Math.toDegrees(radians);
    }
  },
  RADIANS(2 * Math.PI) {
    @Override
    double of(double radians) {
      return radians;
    }
  };

  private static final int ROUNDINGS = 4;

  private final double fullTurn;

  AngleUnit(double fullTurn) {
    this.fullTurn = fullTurn;
  }

  /**
   * Returns the angle in this unit that converts back to exactly these radians, if there is one.
   */
  abstract double of(double radians);

  /** Returns a heading in this unit, a full turn more if it equals {@link CamSim#UNCHANGED}. */
  double heading(double radians) {
    double heading = of(radians);
    return heading == CamSim.UNCHANGED ? heading + fullTurn : heading;
  }
}
