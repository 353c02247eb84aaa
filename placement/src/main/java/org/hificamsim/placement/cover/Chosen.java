package org.hificamsim.placement.cover;

import java.util.Arrays;

/** Candidates that are chosen, and what they see, kept up to date as one comes or goes. */
final class Chosen {
  private final CoverInstance instance;
  private final boolean[] chosen;
  private final int[] counts;
  private double worth;
  private double price;

  Chosen(CoverInstance instance) {
    this.instance = instance;
    this.chosen = new boolean[instance.candidates()];
    this.counts = new int[instance.samples()];
  }

  /** Chooses these and no others. */
  void set(int[] candidates) {
    for (int candidate : candidates()) {
      remove(candidate);
    }
    worth = 0; // without what rounding has left
    price = 0;
    for (int candidate : candidates) {
      add(candidate);
    }
  }

  /** What a candidate would add, or takes away where it is chosen. */
  double gain(int candidate) {
    int least = chosen[candidate] ? 1 : 0;
    double gain = 0;
    for (int sample : instance.columns()[candidate]) {
      gain += counts[sample] - least < instance.needs()[sample] ? instance.units()[sample] : 0;
    }
    return gain;
  }

  /** How many times that are still missing a candidate would add. */
  int missingOf(int candidate) {
    int found = 0;
    for (int sample : instance.columns()[candidate]) {
      found += counts[sample] < instance.needs()[sample] ? 1 : 0;
    }
    return found;
  }

  /** Whether every sample is seen as often as before without one that is chosen. */
  boolean isRedundant(int candidate) {
    for (int sample : instance.columns()[candidate]) {
      if (counts[sample] <= instance.needs()[sample]) {
        return false;
      }
    }
    return true;
  }

  void add(int candidate) {
    worth += gain(candidate);
    price += instance.prices()[candidate];
    chosen[candidate] = true;
    for (int sample : instance.columns()[candidate]) {
      counts[sample]++;
    }
  }

  void remove(int candidate) {
    chosen[candidate] = false;
    for (int sample : instance.columns()[candidate]) {
      counts[sample]--;
    }
    worth -= gain(candidate);
    price -= instance.prices()[candidate];
  }

  boolean has(int candidate) {
    return chosen[candidate];
  }

  /** Rising. */
  int[] candidates() {
    int[] all = new int[chosen.length];
    int count = 0;
    for (int candidate = 0; candidate < chosen.length; candidate++) {
      all[count] = candidate;
      count += chosen[candidate] ? 1 : 0;
    }
    return Arrays.copyOf(all, count);
  }

  int[] counts() {
    return counts;
  }

  double worth() {
    return worth;
  }

  double price() {
    return price;
  }
}
