package org.hificamsim.network.agent;

import java.util.ArrayDeque;
import java.util.Arrays;

/** The bids that have arrived at a camera, by target; lists are reused. */
final class Bids {
  /**
   * The bids for one target in the order of CamSim's map (behaviour 4.5): the first of each bidder.
   */
  static final class OfTarget {
    private final HashOrder order = new HashOrder();
    private int[] bidders = new int[8];
    private double[] values = new double[8];

    private void add(int bidder, double value, int hash) {
      int size = size();
      for (int i = 0; i < size; i++) {
        if (bidders[i] == bidder) {
          return;
        }
      }
      if (size == bidders.length) {
        bidders = Arrays.copyOf(bidders, 2 * size);
        values = Arrays.copyOf(values, 2 * size);
      }
      bidders[size] = bidder;
      values[size] = value;
      order.add(size, hash);
    }

    int size() {
      return order.size();
    }

    int bidder(int index) {
      return bidders[order.get(index)];
    }

    double value(int index) {
      return values[order.get(index)];
    }
  }

  private final OfTarget[] open;
  private final ArrayDeque<OfTarget> spare = new ArrayDeque<>();

  Bids(int targets) {
    open = new OfTarget[targets];
  }

  /**
   * Adds a bid, unless the bidder has bid for this target already.
   *
   * @param hash orders bids; those of one hash code stay in the order of arrival
   */
  void add(int target, int bidder, double value, int hash) {
    if (open[target] == null) {
      open[target] = spare.isEmpty() ? new OfTarget() : spare.pop();
    }
    open[target].add(bidder, value, hash);
  }

  /** The bids for a target, or null without any. */
  OfTarget of(int target) {
    return open[target];
  }

  /** Discards the bids for a target. */
  void clear(int target) {
    if (open[target] != null) {
      open[target].order.reset();
      spare.push(open[target]);
      open[target] = null;
    }
  }
}
