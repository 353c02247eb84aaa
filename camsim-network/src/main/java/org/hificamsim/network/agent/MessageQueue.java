package org.hificamsim.network.agent;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.channel.RadioLog;
import org.hificamsim.core.channel.Stations;

/**
 * Messages in transit, delivered in the order in which they were sent.
 *
 * <p>The network empties the queue after each camera's turn. No camera reads in its own turn what
 * it has sent to another one, so this gives the same numbers as CamSim, which delivers within the
 * call that sends (behaviour 8.2). On an imperfect channel, {@link Post} carries the messages.
 */
public final class MessageQueue {
  /** The receiver of a message to all neighbours of the sender. */
  public static final int NEIGHBOURS = -1;

  /** Delivers messages to cameras. */
  @FunctionalInterface
  public interface Receiver {
    /**
     * Delivers one message.
     *
     * @param to a camera, or {@link #NEIGHBOURS}
     * @param target the target that the message is about
     * @param value confidence or price; 0 if the kind has none
     * @return the number of cameras that received it
     */
    int receive(MessageKind kind, int from, int to, int target, double value);
  }

  private record Message(MessageKind kind, int from, int to, int target, double value) {}

  private final int bitsWithoutValue;

  /** The carrier of messages over the channel; null if the channel is perfect. */
  private Post<Message> post;

  private Stations stations;

  /** The log of the bits of messages that no {@link #post} carries and counts. */
  private RadioLog radio = RadioLog.NONE;

  private final List<Message> waiting = new ArrayList<>();
  private long startSearches;
  private long startTrackings;
  private long bits;

  /** Creates an empty queue for a network of this size. */
  public MessageQueue(int cameras, int targets) {
    bitsWithoutValue =
        MessageBits.of(MessageKind.values().length)
            + MessageBits.address(cameras)
            + MessageBits.of(targets);
  }

  /** Sends all further messages over a channel. */
  public void connect(Stations newStations, Channel channel) {
    stations = newStations;
    radio = channel.isPerfect() ? stations.radio() : RadioLog.NONE;
    post = channel.isPerfect() ? null : new Post<>(stations, channel);
  }

  /** Appends a message to a camera, or to {@link #NEIGHBOURS}. */
  void send(MessageKind kind, int from, int to, int target, double value) {
    bits += bits(kind);
    radio.send(from, bits(kind));
    waiting.add(new Message(kind, from, to, target, value));
  }

  /** Counts a message that a camera receives. */
  public void countReceived(MessageKind kind, int to) {
    radio.receive(to, bits(kind));
  }

  /** Counts a message of one camera that all other online cameras receive. */
  public void countReceivedByAll(MessageKind kind, int from) {
    radio.receiveAll(from, bits(kind), stations);
  }

  private int bits(MessageKind kind) {
    return bitsWithoutValue + (kind.hasValue() ? MessageBits.REAL : 0);
  }

  /** Delivers every message that waits or arrives in this step, and those sent meanwhile. */
  public void deliver(Receiver receiver) {
    if (post == null && waiting.isEmpty()) {
      return;
    }
    deliverWaiting(receiver);
  }

  private void deliverWaiting(Receiver receiver) {
    for (int i = 0; i < waiting.size(); i++) {
      Message message = waiting.get(i);
      if (post == null) {
        deliver(message, message.to, receiver);
      } else if (message.to == NEIGHBOURS) {
        post.broadcast(message.from, bits(message.kind), message);
      } else {
        post.send(message.from, message.to, bits(message.kind), message);
      }
    }
    waiting.clear();
    if (post != null) {
      post.deliver((from, to, sent, message) -> deliver(message, to, receiver));
    }
  }

  private void deliver(Message message, int to, Receiver receiver) {
    count(
        message.kind,
        receiver.receive(message.kind, message.from, to, message.target, message.value));
  }

  private void count(MessageKind kind, int receivers) {
    if (kind == MessageKind.START_SEARCH) {
      startSearches += receivers;
    } else if (kind == MessageKind.START_TRACKING) {
      startTrackings += receivers;
    }
  }

  /** The number of StartSearch messages received since the last {@link #resetCounts}. */
  public long startSearches() {
    return startSearches;
  }

  /** The number of StartTracking messages, or handovers, received since then. */
  public long startTrackings() {
    return startTrackings;
  }

  /** The number of bits of all messages sent so far; a message to all neighbours counts once. */
  public long bits() {
    return bits;
  }

  /** Resets the counts of messages to 0, but not the bits. */
  public void resetCounts() {
    startSearches = 0;
    startTrackings = 0;
  }
}
