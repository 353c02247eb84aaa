package org.hificamsim.network.statistics;

/**
 * A piece of a sector's boundary, walked through anticlockwise as its parameter goes from 0 to 1,
 * so that the inside is on the left.
 */
sealed interface Edge permits Arc, Side {
  double x(double t);

  double y(double t);

  /** The x component of the unit vector to the left. */
  double leftX(double t);

  /** The y component of the unit vector to the left. */
  double leftY(double t);

  /** Half the integral of x dy - y dx from one parameter to another: its share of an area. */
  double areaBetween(double from, double to);

  /** Adds the parameters at which the curve that another edge is part of is crossed. */
  void cross(Edge other, Cuts cuts);
}
