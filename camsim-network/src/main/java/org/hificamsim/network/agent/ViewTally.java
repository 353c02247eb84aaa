package org.hificamsim.network.agent;

/** How many targets both a camera and another see, for the zoom bandit (behaviour 9.6). */
public final class ViewTally {
  private int shared;
  private int all;

  /**
   * Counts a target.
   *
   * @param both whether this camera and another see it, and not one of them alone
   */
  void count(boolean both) {
    shared += both ? 1 : 0;
    all++;
  }

  /** Whether anything has been counted. */
  public boolean counted() {
    return all > 0;
  }

  /** The share of the targets that both see; undefined while nothing is {@link #counted}. */
  public double sharedRatio() {
    return (double) shared / all;
  }

  /** Starts counting at 0. */
  public void reset() {
    shared = 0;
    all = 0;
  }
}
