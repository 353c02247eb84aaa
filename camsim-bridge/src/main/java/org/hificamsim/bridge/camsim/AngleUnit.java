package org.hificamsim.bridge.camsim;

/** What a method of CamSim's may count angles in; inside, CamSim has radians (behaviour 2). */
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

  /** An angle in this unit, which gives these radians again, to the bit where any does. */
  abstract double of(double radians);

  /** The same of a heading, which must not be taken for {@link CamSim#AS_IT_IS}. */
  double heading(double radians) {
    double heading = of(radians);
    return heading == CamSim.AS_IT_IS ? heading + fullTurn : heading;
  }
}
