package org.hificamsim.solver.cover;

import java.util.PriorityQueue;
import java.util.function.IntToDoubleFunction;

/**
 * Selects the candidate with the greatest gain per price, again and again. Because gains only
 * shrink, most of them need not be computed again (Minoux 1978).
 */
final class Greedy {
  private record Entry(int candidate, double ratio) implements Comparable<Entry> {
    @Override
    public int compareTo(Entry other) {
      int order = Double.compare(other.ratio, ratio);
      return order != 0 ? order : Integer.compare(candidate, other.candidate);
    }
  }

  private final CoverInstance instance;
  private final Goal goal;
  private final Selection selection;
  private final IntToDoubleFunction weights;
  private final PriorityQueue<Entry> queue = new PriorityQueue<>();

  /**
   * @param weights for each candidate, the divisor of its gain, which is its price, or 1 to compare
   *     gains
   */
  Greedy(CoverInstance instance, Goal goal, Selection selection, IntToDoubleFunction weights) {
    this.instance = instance;
    this.goal = goal;
    this.selection = selection;
    this.weights = weights;
  }

  /** Adds candidates to the selection until none that can be afforded adds anything. */
  void fill() {
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      enqueue(candidate);
    }
    while (!queue.isEmpty()) {
      Entry first = queue.poll();
      int candidate = first.candidate;
      double price = selection.price() + instance.prices()[candidate];
      if (selection.has(candidate) || !goal.affords(price)) {
        continue;
      }
      if (gain(candidate) / weights.applyAsDouble(candidate) == first.ratio) {
        selection.add(candidate);
      } else {
        enqueue(candidate);
      }
    }
  }

  private void enqueue(int candidate) {
    double gain = selection.has(candidate) ? 0 : gain(candidate);
    if (gain > 0) {
      queue.add(new Entry(candidate, gain / weights.applyAsDouble(candidate)));
    }
  }

  private double gain(int candidate) {
    return goal.isFullCover() ? selection.missingPoints(candidate) : selection.gain(candidate);
  }
}
