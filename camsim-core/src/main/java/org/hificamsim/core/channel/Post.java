package org.hificamsim.core.channel;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.TreeMap;

/**
 * Carries messages of one kind between cameras over a {@link Channel}. Messages are delivered in
 * the order of the steps in which they arrive, and within a step in the order of sending. Not
 * thread-safe.
 *
 * @param <M> the content of a message
 */
public final class Post<M> {
  /** Receives the messages that arrive. */
  @FunctionalInterface
  public interface Receiver<M> {
    /**
     * Receives a message.
     *
     * @param sent the step in which it was sent
     */
    void receive(int from, int to, long sent, M message);
  }

  private record Copy<M>(int from, int to, long sent, long bits, M message) {}

  private final Stations stations;
  private final Channel channel;
  private final TreeMap<Long, Queue<Copy<M>>> arriving = new TreeMap<>();

  /** Creates a post without messages. */
  public Post(Stations stations, Channel channel) {
    this.stations = stations;
    this.channel = channel;
  }

  /** Sends a message from one camera to another. */
  public void send(int from, int to, long bits, M message) {
    if (channel.send(from, bits)) {
      stations.radio().send(from, bits);
      copy(from, to, bits, message);
    }
  }

  /** Sends a message from a camera to all others that are online. */
  public void broadcast(int from, long bits, M message) {
    if (channel.send(from, bits)) {
      stations.radio().send(from, bits);
      for (int to = 0; to < stations.cameras(); to++) {
        if (to != from && stations.online(to)) {
          copy(from, to, bits, message);
        }
      }
    }
  }

  private void copy(int from, int to, long bits, M message) {
    int delay = channel.delay(from, to);
    if (delay != Channel.LOST) {
      long sent = stations.step();
      Queue<Copy<M>> copies = arriving.computeIfAbsent(sent + delay, step -> new ArrayDeque<>());
      copies.add(new Copy<>(from, to, sent, bits, message));
    }
  }

  /**
   * Delivers all messages that have arrived by this step, including those sent during delivery that
   * take no time. Cameras that are offline miss their messages.
   */
  public void deliver(Receiver<M> receiver) {
    while (!arriving.isEmpty() && arriving.firstKey() <= stations.step()) {
      Queue<Copy<M>> copies = arriving.firstEntry().getValue();
      for (Copy<M> copy = copies.poll(); copy != null; copy = copies.poll()) {
        if (stations.online(copy.to())) {
          stations.radio().receive(copy.to(), copy.bits());
          receiver.receive(copy.from(), copy.to(), copy.sent(), copy.message());
        }
      }
      arriving.pollFirstEntry();
    }
  }
}
