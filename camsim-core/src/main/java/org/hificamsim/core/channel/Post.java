package org.hificamsim.core.channel;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.TreeMap;

/**
 * Messages between cameras that are on their way over a {@link Channel}, of one kind of content.
 * They are delivered in the order of the steps in which they arrive, and within a step in that of
 * sending. From one thread.
 */
public final class Post<M> {
  /** Who is given what arrives. */
  @FunctionalInterface
  public interface Receiver<M> {
    /**
     * @param sent the step in which it was sent
     */
    void receive(int from, int to, long sent, M message);
  }

  private record Copy<M>(int from, int to, long sent, M message) {}

  private final Stations stations;
  private final Channel channel;
  private final TreeMap<Long, Queue<Copy<M>>> arriving = new TreeMap<>();

  /** Nothing is on its way. */
  public Post(Stations stations, Channel channel) {
    this.stations = stations;
    this.channel = channel;
  }

  /** A camera sends a message to another one. */
  public void send(int from, int to, long bits, M message) {
    if (channel.send(from, bits)) {
      copy(from, to, message);
    }
  }

  /** A camera sends a message to all others that are online. */
  public void broadcast(int from, long bits, M message) {
    if (channel.send(from, bits)) {
      for (int to = 0; to < stations.cameras(); to++) {
        if (to != from && stations.online(to)) {
          copy(from, to, message);
        }
      }
    }
  }

  private void copy(int from, int to, M message) {
    int delay = channel.delay(from, to);
    if (delay != Channel.LOST) {
      long sent = stations.step();
      Queue<Copy<M>> copies = arriving.computeIfAbsent(sent + delay, step -> new ArrayDeque<>());
      copies.add(new Copy<>(from, to, sent, message));
    }
  }

  /**
   * Hands over all that has arrived by this step, and what is sent meanwhile and takes no time;
   * cameras that are offline miss what arrives.
   */
  public void deliver(Receiver<M> receiver) {
    while (!arriving.isEmpty() && arriving.firstKey() <= stations.step()) {
      Queue<Copy<M>> copies = arriving.firstEntry().getValue();
      for (Copy<M> copy = copies.poll(); copy != null; copy = copies.poll()) {
        if (stations.online(copy.to())) {
          receiver.receive(copy.from(), copy.to(), copy.sent(), copy.message());
        }
      }
      arriving.pollFirstEntry();
    }
  }
}
