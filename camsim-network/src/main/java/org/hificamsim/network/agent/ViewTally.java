package org.hificamsim.network.agent;

/** Which of a camera's targets others see too, counted for the zoom bandit (behaviour 9.6). */
public final class ViewTally {
  private int shared;
  private int yours;
  private int alone;

  /** An auction ended without bids; the seller sees the target or not. */
  void unsold(boolean visible) {
    if (visible) {
      alone++;
    }
  }

  /** An auction was won by the seller itself. */
  void kept(boolean visible, int bids) {
    if (visible && bids > 1) {
      shared++;
    }
  }

  /** A target was handed over. */
  void sold(boolean visible) {
    if (visible) {
      shared++;
    } else {
      yours++;
    }
  }

  /** Another camera keeps a target that this one sees. */
  void seenElsewhere() {
    shared++;
  }

  /** Whether anything has been counted. */
  public boolean counted() {
    return shared + yours + alone > 0;
  }

  /** The share of targets that others see too; undefined while nothing is {@link #counted}. */
  public double sharedRatio() {
    return (double) shared / (shared + yours + alone);
  }

  /** Starts counting at 0. */
  public void reset() {
    shared = 0;
    yours = 0;
    alone = 0;
  }
}
