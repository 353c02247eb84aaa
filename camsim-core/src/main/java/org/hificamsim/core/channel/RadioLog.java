package org.hificamsim.core.channel;

import java.util.Arrays;

/** The bits that each camera has sent and received in a step, if they are counted. */
public final class RadioLog {
  /** The log that counts nothing. */
  public static final RadioLog NONE = new RadioLog(0);

  private final long[] sent;
  private final long[] everSent;
  private final long[] received;

  /** Creates a log of a number of cameras. */
  public RadioLog(int cameras) {
    sent = new long[cameras];
    everSent = new long[cameras];
    received = new long[cameras];
  }

  /** Whether the log counts, so that receivers have to be found. */
  public boolean counts() {
    return sent.length > 0;
  }

  /** Counts a message that a camera sends. */
  public void send(int from, long bits) {
    if (counts()) {
      sent[from] += bits;
      everSent[from] += bits;
    }
  }

  /** Counts a message that a camera receives. */
  public void receive(int to, long bits) {
    if (counts()) {
      received[to] += bits;
    }
  }

  /** Counts a message that all other online cameras receive. */
  public void receiveAll(int from, long bits, Stations stations) {
    for (int to = 0; to < sent.length; to++) {
      if (to != from && stations.online(to)) {
        received[to] += bits;
      }
    }
  }

  /** The bits that a camera has sent since the last {@link #clear}. */
  public long sent(int camera) {
    return sent[camera];
  }

  /** The bits that a camera has sent since the start of the run. */
  public long everSent(int camera) {
    return everSent[camera];
  }

  /** The bits that a camera has received since the last {@link #clear}. */
  public long received(int camera) {
    return received[camera];
  }

  /** Starts a step: forgets the bits of the step before. */
  public void clear() {
    Arrays.fill(sent, 0);
    Arrays.fill(received, 0);
  }
}
