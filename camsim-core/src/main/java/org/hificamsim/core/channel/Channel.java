package org.hificamsim.core.channel;

import java.util.stream.LongStream;
import org.hificamsim.core.Draw;

/**
 * The channel of a run: decides which messages arrive, and when. {@link Post} carries messages over
 * it.
 *
 * <p>A camera {@link #send sends} a message once for all its receivers, and then asks for the
 * {@link #delay} of each receiver's copy. Copies that travel over the same hop share its delay and
 * loss. Draws depend on seed, step, link, sender and the number of the message among those that the
 * sender sends in the step ({@link Draw}), so that messages of other cameras change nothing. With
 * random delays, messages may overtake each other. Not thread-safe.
 */
public final class Channel {
  /** The delay of a copy that never arrives. */
  public static final int LOST = -1;

  /** The channel that delivers everything at once; senders need not ask it. */
  public static final Channel PERFECT = new Channel();

  private static final long STREAM = 0x4348414E;

  private final ChannelModel model;
  private final boolean perfect;
  private final Stations stations;

  /** The links within radio range; null if all cameras receive each other. */
  private final RadioGraph radio;

  private final long drawKey;

  /** The step in which each camera last sent. */
  private final long[] lastSent;

  /** The number of each camera's last message among its messages of that step. */
  private final int[] messageNumbers;

  /** The bits in each camera's queue in that step. */
  private final long[] queuedBits;

  /** The number of steps that each camera's last message waits in the queue. */
  private final int[] queueDelays;

  private final long[] dropped;

  private Channel() {
    this(ChannelModel.PERFECT, null, 0, 0);
  }

  /**
   * @param stations the cameras of the run
   * @param seed the seed of the run
   */
  public Channel(ChannelModel model, Stations stations, long seed) {
    this(model, stations, seed, stations.cameras());
  }

  private Channel(ChannelModel model, Stations stations, long seed, int cameras) {
    this.model = model;
    this.perfect = model.isPerfect();
    this.stations = stations;
    this.radio = model.range() > 0 ? new RadioGraph(stations, model.range()) : null;
    this.drawKey = Draw.key(Draw.key(seed, 1), STREAM);
    this.lastSent = new long[cameras];
    this.messageNumbers = new int[cameras];
    this.queuedBits = new long[cameras];
    this.queueDelays = new int[cameras];
    this.dropped = new long[cameras];
  }

  /** Whether everything arrives in the step in which it is sent. */
  public boolean isPerfect() {
    return perfect;
  }

  /** The number of messages so far that did not fit into their sender's queue. */
  public long dropped() {
    return LongStream.of(dropped).sum();
  }

  /**
   * Sends a message in this step. It waits until the messages before it are sent, at the bandwidth;
   * if the queue has no room for it, it is dropped.
   *
   * @param bits length of the message, 0 or more
   * @return whether the message is sent
   */
  public boolean send(int from, long bits) {
    long now = stations.step();
    long passed = now - lastSent[from];
    messageNumbers[from] = passed == 0 ? messageNumbers[from] + 1 : 0;
    lastSent[from] = now;
    return model.bandwidth() == 0 || queue(from, bits, passed);
  }

  private boolean queue(int from, long bits, long passed) {
    long before = Math.max(0, queuedBits[from] - passed * model.bandwidth());
    boolean fits = before + bits <= model.bandwidth() + model.queue();
    queuedBits[from] = fits ? before + bits : before;
    queueDelays[from] = (int) (Math.max(0, before + bits - 1) / model.bandwidth());
    dropped[from] += fits ? 0 : 1;
    return fits;
  }

  /**
   * Returns how many steps a receiver's copy of the sender's last message takes: 0 if it arrives in
   * the same step; {@link #LOST} if never.
   */
  public int delay(int from, int to) {
    int wait = queueDelays[from];
    int travel = radio == null ? hop(from, from, to, wait) : travelTime(from, to, wait);
    return travel == LOST ? LOST : wait + travel;
  }

  /** Returns the steps over all hops to a receiver; a hop begins when the previous one ends. */
  private int travelTime(int from, int to, int wait) {
    int previous = radio.predecessor(from, to);
    int before = previous == from || previous == LOST ? 0 : travelTime(from, previous, wait);
    if (previous == LOST || before == LOST) {
      return LOST;
    }
    int hop = hop(from, previous, to, wait + before);
    return hop == LOST ? LOST : before + hop;
  }

  private int hop(int from, int previous, int to, int after) {
    long step = lastSent[from] + after;
    long link = Draw.key(drawKey, ((long) previous << 32) | to);
    long message = Draw.key(Draw.key(Draw.key(~link, step), from), messageNumbers[from]);
    return model.loss().loses(link, step, Draw.unit(message))
        ? LOST
        : model.delay().steps(Draw.unit(Draw.key(message, 1)));
  }
}
