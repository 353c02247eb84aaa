package org.hificamsim.solver.cover;

import java.util.Arrays;

/** The selected candidates, with the number of times that they cover each point. */
final class Selection {
  private final CoverInstance instance;
  private final boolean[] selected;
  private final int[] counts;
  private double worth;
  private double price;

  Selection(CoverInstance instance) {
    this.instance = instance;
    this.selected = new boolean[instance.candidates()];
    this.counts = new int[instance.points()];
  }

  /** Selects these candidates and no others. */
  void set(int[] candidates) {
    for (int candidate : candidates()) {
      remove(candidate);
    }
    worth = 0; // removes rounding errors
    price = 0;
    for (int candidate : candidates) {
      add(candidate);
    }
  }

  /** The worth that a candidate adds, or would add if it were selected. */
  double gain(int candidate) {
    int ownCover = selected[candidate] ? 1 : 0;
    double gain = 0;
    for (int point : instance.covered()[candidate]) {
      gain += counts[point] - ownCover < instance.needs()[point] ? instance.unitWorths()[point] : 0;
    }
    return gain;
  }

  /** The number of points of a candidate that are not yet covered as often as needed. */
  int missingPoints(int candidate) {
    int missing = 0;
    for (int point : instance.covered()[candidate]) {
      missing += counts[point] < instance.needs()[point] ? 1 : 0;
    }
    return missing;
  }

  /** Whether all points of a selected candidate are covered as often as needed without it. */
  boolean isRedundant(int candidate) {
    for (int point : instance.covered()[candidate]) {
      if (counts[point] <= instance.needs()[point]) {
        return false;
      }
    }
    return true;
  }

  void add(int candidate) {
    worth += gain(candidate);
    price += instance.prices()[candidate];
    selected[candidate] = true;
    for (int point : instance.covered()[candidate]) {
      counts[point]++;
    }
  }

  void remove(int candidate) {
    selected[candidate] = false;
    for (int point : instance.covered()[candidate]) {
      counts[point]--;
    }
    worth -= gain(candidate);
    price -= instance.prices()[candidate];
  }

  boolean has(int candidate) {
    return selected[candidate];
  }

  /** The selected candidates, in ascending order. */
  int[] candidates() {
    int[] candidates = new int[selected.length];
    int count = 0;
    for (int candidate = 0; candidate < selected.length; candidate++) {
      candidates[count] = candidate;
      count += selected[candidate] ? 1 : 0;
    }
    return Arrays.copyOf(candidates, count);
  }

  double worth() {
    return worth;
  }

  double price() {
    return price;
  }
}
