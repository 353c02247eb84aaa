package org.hificamsim.network.agent;

/** Takes delivered messages and brings each to the camera that it is for. */
@FunctionalInterface
public interface Receiver {
  /**
   * @param target what the message is about
   * @param value confidence or price; 0 where the kind has none
   */
  void receive(MessageKind kind, int from, int to, int target, double value);
}
