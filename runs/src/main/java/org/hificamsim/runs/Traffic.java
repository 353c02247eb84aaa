package org.hificamsim.runs;

import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.engine.NetworkSums;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * What the cameras of a run sent each other.
 *
 * @param messages one to all others counts once
 * @param bits of these
 * @param dropped messages that found no place in a queue; NaN over a perfect channel
 */
public record Traffic(long messages, long bits, double dropped) {
  /** Nothing was sent. */
  public static final Traffic NONE = new Traffic(0, 0, Double.NaN);

  /** What a policy sent over a channel. */
  static Traffic of(ZoomPolicy policy, Channel channel) {
    return new Traffic(policy.messages(), policy.bits(), 0).over(channel);
  }

  /** The same over the channel that it went over. */
  public Traffic over(Channel channel) {
    return new Traffic(messages, bits, channel.isPerfect() ? Double.NaN : channel.dropped());
  }

  /** This, and what a network sent of the same run. */
  Traffic with(NetworkSums network) {
    return new Traffic(messages + network.messages(), bits + network.bits(), dropped);
  }

  /** This, and more of the same run. */
  public Traffic plus(Traffic more) {
    return new Traffic(messages + more.messages, bits + more.bits, dropped + more.dropped);
  }
}
