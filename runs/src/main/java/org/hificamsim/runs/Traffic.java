package org.hificamsim.runs;

import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.engine.NetworkSums;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * The messages between the cameras of a run.
 *
 * @param messages the number of messages; one to all other cameras counts once
 * @param bits the bits of these messages
 * @param dropped the number of messages that found their sender's queue full; NaN over a perfect
 *     channel
 */
public record Traffic(long messages, long bits, double dropped) {
  /** No messages. */
  public static final Traffic NONE = new Traffic(0, 0, Double.NaN);

  /** The messages of a policy over a channel. */
  static Traffic of(ZoomPolicy policy, Channel channel) {
    return new Traffic(policy.messages(), policy.bits(), 0).over(channel);
  }

  /** The same messages with the number that their channel dropped. */
  public Traffic over(Channel channel) {
    return new Traffic(messages, bits, channel.isPerfect() ? Double.NaN : channel.dropped());
  }

  /** These messages and those of the same run's network. */
  Traffic with(NetworkSums network) {
    return new Traffic(messages + network.messages(), bits + network.bits(), dropped);
  }

  /** These messages and others of the same run. */
  public Traffic plus(Traffic other) {
    return new Traffic(messages + other.messages, bits + other.bits, dropped + other.dropped);
  }
}
