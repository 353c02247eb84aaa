package org.hificamsim.network.agent;

import java.util.ArrayDeque;

/** The bids that have arrived at a camera, by target; lists are used again. */
public final class BidBook {
  private final Bids[] open;
  private final ArrayDeque<Bids> spare = new ArrayDeque<>();
  private final boolean hashed;

  BidBook(int targets, boolean hashed) {
    open = new Bids[targets];
    this.hashed = hashed;
  }

  /** Adds a bid, unless the bidder has bid for this target already. */
  void add(int target, int bidder, double value, int hash) {
    if (open[target] == null) {
      open[target] = spare.isEmpty() ? new Bids(hashed) : spare.pop();
    }
    open[target].add(bidder, value, hash);
  }

  /** The bids for a target, or null without any. */
  public Bids of(int target) {
    return open[target];
  }

  /** Throws the bids for a target away. */
  public void clear(int target) {
    if (open[target] != null) {
      open[target].clear();
      spare.push(open[target]);
      open[target] = null;
    }
  }
}
