package org.hificamsim.network.agent;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.channel.Stations;

/**
 * The messages on their way, delivered in the order in which they were sent.
 *
 * <p>The network empties the queue after each camera's turn. No camera reads in its own turn what
 * it writes to another one, so that this gives the same numbers as CamSim's delivery within the
 * call that sends (behaviour 8.2). Over a channel that is not perfect they go on by {@link Post}.
 */
public final class MessageQueue {
  /** Stands for all neighbours of the camera that sends. */
  public static final int NEIGHBOURS = -1;

  /** Brings messages to the cameras that they are for. */
  @FunctionalInterface
  public interface Receiver {
    /**
     * Brings one.
     *
     * @param to a camera, or {@link #NEIGHBOURS}
     * @param target what the message is about
     * @param value confidence or price; 0 where the kind has none
     * @return how many cameras received it
     */
    int receive(MessageKind kind, int from, int to, int target, double value);
  }

  private record Letter(MessageKind kind, int from, int to, int target, double value) {}

  private final int bitsWithoutValue;
  private Post<Letter> post; // null where all arrives at once
  private final List<Letter> waiting = new ArrayList<>();
  private long startSearches;
  private long startTrackings;
  private long bits;

  /** An empty queue of a network with this many cameras and targets. */
  public MessageQueue(int cameras, int targets) {
    bitsWithoutValue =
        MessageBits.of(MessageKind.values().length)
            + MessageBits.address(cameras)
            + MessageBits.of(targets);
  }

  /** From now on messages go over a channel. */
  public void connect(Stations stations, Channel channel) {
    post = channel.isPerfect() ? null : new Post<>(stations, channel);
  }

  /** Appends a message to a camera, or to {@link #NEIGHBOURS}. */
  void send(MessageKind kind, int from, int to, int target, double value) {
    bits += bits(kind);
    waiting.add(new Letter(kind, from, to, target, value));
  }

  private int bits(MessageKind kind) {
    return bitsWithoutValue + (kind.hasValue() ? MessageBits.REAL : 0);
  }

  /** Delivers every message that waits or arrives in this step, also those that arise meanwhile. */
  public void deliver(Receiver receiver) {
    for (int i = 0; i < waiting.size(); i++) {
      Letter letter = waiting.get(i);
      if (post == null) {
        deliver(letter, letter.to, receiver);
      } else if (letter.to == NEIGHBOURS) {
        post.broadcast(letter.from, bits(letter.kind), letter);
      } else {
        post.send(letter.from, letter.to, bits(letter.kind), letter);
      }
    }
    waiting.clear();
    if (post != null) {
      post.deliver((from, to, sent, letter) -> deliver(letter, to, receiver));
    }
  }

  private void deliver(Letter letter, int to, Receiver receiver) {
    count(letter.kind, receiver.receive(letter.kind, letter.from, to, letter.target, letter.value));
  }

  private void count(MessageKind kind, int receivers) {
    if (kind == MessageKind.START_SEARCH) {
      startSearches += receivers;
    } else if (kind == MessageKind.START_TRACKING) {
      startTrackings += receivers;
    }
  }

  /** How many StartSearch messages cameras have received since the last {@link #resetCounts}. */
  public long startSearches() {
    return startSearches;
  }

  /** How many StartTracking messages, that is handovers, cameras have received since then. */
  public long startTrackings() {
    return startTrackings;
  }

  /** How many bits all messages had that were sent so far, one to all neighbours once. */
  public long bits() {
    return bits;
  }

  /** Starts counting at 0, but for bits. */
  public void resetCounts() {
    startSearches = 0;
    startTrackings = 0;
  }
}
