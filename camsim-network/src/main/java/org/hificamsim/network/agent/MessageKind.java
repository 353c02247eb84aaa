package org.hificamsim.network.agent;

/** The messages that cameras send each other (behaviour 8.2). */
public enum MessageKind {
  /** The sender owns a target and takes bids for it. */
  START_SEARCH,
  /** The receiver is to stop its search for a target. */
  STOP_SEARCH,
  /** A bid: the sender sees the target; the value is its confidence. */
  FOUND,
  /** The sender sold the target to the receiver; the value is the price. */
  START_TRACKING;

  /** Returns whether messages of this kind have a value. */
  boolean hasValue() {
    return this == FOUND || this == START_TRACKING;
  }
}
