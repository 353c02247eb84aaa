package org.hificamsim.network.agent;

import java.util.Arrays;

/** The bids for one target: at most one a camera, the first. */
public final class Bids {
  private int[] bidders = new int[8];
  private double[] values = new double[8];
  private int size;
  private final HashOrder byHash;

  /**
   * @param hashed whether the order is that of CamSim's map (behaviour 4.5), not that of arrival
   */
  Bids(boolean hashed) {
    byHash = hashed ? new HashOrder() : null;
  }

  void add(int bidder, double value, int hash) {
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
    if (byHash != null) {
      byHash.add(size, hash);
    }
    size++;
  }

  void clear() {
    size = 0;
    if (byHash != null) {
      byHash.reset();
    }
  }

  public int size() {
    return size;
  }

  public int bidder(int index) {
    return bidders[place(index)];
  }

  public double value(int index) {
    return values[place(index)];
  }

  private int place(int index) {
    return byHash == null ? index : byHash.get(index);
  }
}
