package org.hificamsim.agents.cooperative;

/**
 * Where known targets are going to be, step by step up to the horizon. A target in a step is a
 * slot: {@code target * horizon + step}.
 */
final class Forecast {
  private final int horizon;
  private final double[] discounts;
  private int slots;
  private double[] x = {};
  private double[] y = {};
  private double[] size = {};
  private double[] weight = {};

  Forecast(Parameters parameters) {
    horizon = parameters.horizon();
    discounts = new double[horizon];
    discounts[0] = 1;
    for (int step = 1; step < horizon; step++) {
      discounts[step] = discounts[step - 1] * parameters.discount();
    }
  }

  /** Looks ahead from where targets are believed to be. */
  void update(TargetTracks tracks) {
    slots = tracks.count() * horizon;
    if (x.length < slots) {
      x = new double[2 * slots];
      y = new double[2 * slots];
      size = new double[2 * slots];
      weight = new double[2 * slots];
    }
    for (int i = 0; i < tracks.count(); i++) {
      tracks.follow(tracks.at(i), this, i * horizon);
    }
  }

  /** A target is going to be at a place. */
  void set(int slot, double atX, double atY, double itsSize, double itsWeight) {
    x[slot] = atX;
    y[slot] = atY;
    size[slot] = itsSize;
    weight[slot] = itsWeight * discounts[step(slot)];
  }

  int slots() {
    return slots;
  }

  int horizon() {
    return horizon;
  }

  /** How many steps from now a slot is, 0 for the one under way. */
  int step(int slot) {
    return slot % horizon;
  }

  /** What all steps count from one on. */
  double weightFrom(int step) {
    double sum = 0;
    for (int later = step; later < horizon; later++) {
      sum += discounts[later];
    }
    return sum;
  }

  double x(int slot) {
    return x[slot];
  }

  double y(int slot) {
    return y[slot];
  }

  double size(int slot) {
    return size[slot];
  }

  /** How much the target counts in that step. */
  double weight(int slot) {
    return weight[slot];
  }
}
