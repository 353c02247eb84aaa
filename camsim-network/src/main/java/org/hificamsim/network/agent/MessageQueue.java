package org.hificamsim.network.agent;

import java.util.Arrays;

/**
 * The messages on their way, in flat arrays, delivered in the order in which they were sent.
 *
 * <p>The network empties the queue after each camera's turn. No camera reads in its own turn what
 * it writes to another one, so that this gives the same numbers as CamSim's delivery within the
 * call that sends (behaviour 8.2). A channel that delays or loses messages belongs in {@link
 * #deliver}.
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

  private MessageKind[] kinds = new MessageKind[64];
  private int[] froms = new int[64];
  private int[] tos = new int[64];
  private int[] targets = new int[64];
  private double[] values = new double[64];
  private int waiting;
  private long startSearches;
  private long startTrackings;

  /** Appends a message to a camera, or to {@link #NEIGHBOURS}. */
  void send(MessageKind kind, int from, int to, int target, double value) {
    if (waiting == kinds.length) {
      grow();
    }
    kinds[waiting] = kind;
    froms[waiting] = from;
    tos[waiting] = to;
    targets[waiting] = target;
    values[waiting++] = value;
  }

  /** Delivers every message that waits, also those that arise on the way. */
  public void deliver(Receiver receiver) {
    for (int i = 0; i < waiting; i++) {
      count(kinds[i], receiver.receive(kinds[i], froms[i], tos[i], targets[i], values[i]));
    }
    waiting = 0;
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

  /** Starts counting at 0. */
  public void resetCounts() {
    startSearches = 0;
    startTrackings = 0;
  }

  private void grow() {
    int length = 2 * waiting;
    kinds = Arrays.copyOf(kinds, length);
    froms = Arrays.copyOf(froms, length);
    tos = Arrays.copyOf(tos, length);
    targets = Arrays.copyOf(targets, length);
    values = Arrays.copyOf(values, length);
  }
}
