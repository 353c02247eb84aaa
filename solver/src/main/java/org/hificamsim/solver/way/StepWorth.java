package org.hificamsim.solver.way;

/**
 * The worth that a target adds to the sum of a step, by the number of cameras that detect it: a
 * table that never falls.
 */
record StepWorth(double[] values) {
  double value(int k) {
    return values[Math.min(k, values.length - 1)];
  }

  double gain(int k) {
    return value(k + 1) - value(k);
  }

  /** The greatest gain of one camera among the first {@code max}. */
  double greatestGain(int max) {
    double greatest = 0;
    for (int k = 0; k < Math.min(max, values.length - 1); k++) {
      greatest = Math.max(greatest, gain(k));
    }
    return greatest;
  }

  /** The greatest gain per camera if one to {@code more} cameras join {@code k} others. */
  double slope(int k, int more) {
    double slope = 0;
    for (int add = 1; add <= more && k + add < values.length; add++) {
      slope = Math.max(slope, (values[k + add] - values[k]) / add);
    }
    return slope;
  }

  /** The number of further cameras, up to {@code more}, with the greatest profit at a price. */
  int demand(int k, int more, double price) {
    int demand = 0;
    for (int add = 1; add <= more && k + add < values.length; add++) {
      demand = values[k + add] - price * add > value(k + demand) - price * demand ? add : demand;
    }
    return demand;
  }

  double profit(int k, int more, double price) {
    int demand = demand(k, more, price);
    return value(k + demand) - price * demand;
  }
}
