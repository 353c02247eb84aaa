package org.hificamsim.bridge.camsim;

/**
 * The units in which a method of CamSim may take angles. CamSim itself stores radians in any case
 * (behaviour 2).
 */
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
   * Converts radians to this unit. The result converts back to exactly the same radians, if there
   * is such a number.
   */
  abstract double of(double radians);

  /**
   * Converts a heading to this unit. A result that would equal {@link CamSim#UNCHANGED} is a full
   * turn more.
   */
  double heading(double radians) {
    double heading = of(radians);
    return heading == CamSim.UNCHANGED ? heading + fullTurn : heading;
  }
}
