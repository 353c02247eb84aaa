package org.hificamsim.placement.cover;

import java.util.PriorityQueue;
import java.util.function.IntToDoubleFunction;

/**
 * Takes the candidate with the greatest gain for its price, again and again. Gains only shrink, so
 * that most need not be computed again (Minoux 1978).
 */
final class Greedy {
  private record Entry(int candidate, double ratio) implements Comparable<Entry> {
    @Override
    public int compareTo(Entry other) {
      int order = Double.compare(other.ratio, ratio);
      return order != 0 ? order : Integer.compare(candidate, other.candidate);
    }
  }

  private Greedy() {}

  /**
   * Adds candidates until nothing that can be paid adds anything.
   *
   * @param weights by which gains are divided: prices, or 1 for gains alone
   */
  static void fill(Chosen plan, CoverInstance instance, Goal goal, IntToDoubleFunction weights) {
    PriorityQueue<Entry> queue = new PriorityQueue<>();
    for (int j = 0; j < instance.candidates(); j++) {
      offer(queue, plan, goal, j, weights);
    }
    while (!queue.isEmpty()) {
      Entry first = queue.poll();
      if (plan.has(first.candidate)
          || !goal.affords(plan.price() + instance.prices()[first.candidate])) {
        continue;
      }
      if (gain(plan, goal, first.candidate) / weights.applyAsDouble(first.candidate)
          == first.ratio) {
        plan.add(first.candidate);
      } else {
        offer(queue, plan, goal, first.candidate, weights);
      }
    }
  }

  private static void offer(
      PriorityQueue<Entry> queue, Chosen plan, Goal goal, int j, IntToDoubleFunction weights) {
    double gain = plan.has(j) ? 0 : gain(plan, goal, j);
    if (gain > 0) {
      queue.add(new Entry(j, gain / weights.applyAsDouble(j)));
    }
  }

  private static double gain(Chosen plan, Goal goal, int candidate) {
    return goal.isAll() ? plan.missingOf(candidate) : plan.gain(candidate);
  }
}
