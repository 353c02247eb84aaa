package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The predicted positions of known targets, step by step up to the horizon. Each pair of a target
 * and a step has a slot: {@code i * horizon + step} for the i-th known target, which is not the
 * number of its track ({@link Plan#targetAndStep}).
 */
final class Forecast {
  private final int horizon;
  private final double[] discounts;
  private int slots;
  private double[] xs = {};
  private double[] ys = {};
  private double[] sizes = {};
  private double[] weights = {};

  /** The targets that hide others, by step. */
  private final Hiding[] hidings;

  Forecast(Parameters parameters) {
    horizon = parameters.horizon();
    discounts = new double[horizon];
    discounts[0] = 1;
    for (int step = 1; step < horizon; step++) {
      discounts[step] = discounts[step - 1] * parameters.discount();
    }
    hidings = new Hiding[horizon];
    Arrays.setAll(hidings, step -> new Hiding());
  }

  /**
   * Predicts all slots from where targets are believed to be now.
   *
   * @param hidingWidth width of targets that hide each other, in metres; 0 if they hide nothing
   */
  void update(TargetTracks tracks, double hidingWidth) {
    for (int step = 0; step < horizon; step++) {
      hidings[step].clear(hidingWidth, step * tracks.meanStepLength());
    }
    slots = tracks.count() * horizon;
    if (xs.length < slots) {
      xs = new double[2 * slots];
      ys = new double[2 * slots];
      sizes = new double[2 * slots];
      weights = new double[2 * slots];
    }
    for (int i = 0; i < tracks.count(); i++) {
      tracks.predict(tracks.track(i), this, i * horizon);
    }
  }

  /**
   * Sets where the target of a slot is going to be in its step; to be called slot after slot.
   *
   * @param weight how much the target counts, before the discount of the step
   */
  void set(int slot, double x, double y, double size, double weight) {
    xs[slot] = x;
    ys[slot] = y;
    sizes[slot] = size;
    weights[slot] = weight * discounts[step(slot)];
    hidings[step(slot)].add(x, y, weight);
  }

  /** The chance that no other target is going to hide the target of a slot from a camera. */
  double visibleShare(NetworkView network, int camera, int slot) {
    return hidings[step(slot)].visibleShare(network, camera, slot / horizon, sizes[slot]);
  }

  /** The number of slots. */
  int slots() {
    return slots;
  }

  /** The number of steps. */
  int horizon() {
    return horizon;
  }

  /** The number of steps from now to the step of a slot; 0 for the present one. */
  int step(int slot) {
    return slot % horizon;
  }

  /** The weight of a step, compared with the present one. */
  double discount(int step) {
    return discounts[step];
  }

  /** The sum of the discounts of a step and all later ones. */
  double sumOfDiscountsFrom(int step) {
    double sum = 0;
    for (int later = step; later < horizon; later++) {
      sum += discounts[later];
    }
    return sum;
  }

  /** The expected x coordinate of the target of a slot, in metres. */
  double x(int slot) {
    return xs[slot];
  }

  double y(int slot) {
    return ys[slot];
  }

  /** The size of the target of a slot, in metres. */
  double size(int slot) {
    return sizes[slot];
  }

  /** Returns the weight of a slot's target in its step. */
  double weight(int slot) {
    return weights[slot];
  }
}
