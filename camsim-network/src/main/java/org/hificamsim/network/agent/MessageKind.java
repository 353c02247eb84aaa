package org.hificamsim.network.agent;

/** The messages that cameras send each other (behaviour 8.2). */
public enum MessageKind {
  /** The sender owns a target and takes bids for it. */
  START_SEARCH,
  /** A target is no longer to be looked for. */
  STOP_SEARCH,
  /** A bid: the sender sees the target; the value says how well. */
  FOUND,
  /** The sender sold the target to the receiver; the value is the price. */
  START_TRACKING;

  /** Whether a message of the kind has a value. */
  boolean hasValue() {
    return this == FOUND || this == START_TRACKING;
  }
}
