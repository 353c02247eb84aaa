package org.hificamsim.core.channel;

import java.util.stream.LongStream;
import org.hificamsim.core.Draw;

/**
 * The channel of a run: which messages arrive, and when. {@link Post} carries messages over it.
 *
 * <p>A camera {@link #send sends} a message, once for all that are to have it, and then asks for
 * each of these how long its copy takes. The same message goes to all over the same hops, and
 * shares what becomes of it there. Draws are by seed, step, link, sender and the number of the
 * message among the sender's of this step ({@link Draw}), so that what other cameras send changes
 * nothing. Messages may overtake each other where delays are drawn. From one thread.
 */
public final class Channel {
  /** A copy that never arrives. */
  public static final int LOST = -1;

  /** Everything arrives at once: who sends need not ask. */
  public static final Channel PERFECT = new Channel();

  private static final long STREAM = 0x4348414E;

  private final ChannelModel model;
  private final boolean perfect;
  private final Stations stations;
  private final RadioGraph radio; // null where all cameras receive each other
  private final long start;
  private final long[] steps; // by camera: in which it sent last
  private final int[] numbers; // of the last message among those of the step
  private final long[] waiting; // bits, at that step
  private final int[] waits; // steps, of the last message
  private final long[] dropped;

  private Channel() {
    this(ChannelModel.PERFECT, null, 0, 0);
  }

  /**
   * @param stations the cameras of the run
   * @param seed of the run
   */
  public Channel(ChannelModel model, Stations stations, long seed) {
    this(model, stations, seed, stations.cameras());
  }

  private Channel(ChannelModel model, Stations stations, long seed, int cameras) {
    this.model = model;
    this.perfect = model.isPerfect();
    this.stations = stations;
    this.radio = model.range() > 0 ? new RadioGraph(stations, model.range()) : null;
    this.start = Draw.key(Draw.key(seed, 1), STREAM);
    this.steps = new long[cameras];
    this.numbers = new int[cameras];
    this.waiting = new long[cameras];
    this.waits = new int[cameras];
    this.dropped = new long[cameras];
  }

  /** Whether everything arrives in the step in which it is sent. */
  public boolean isPerfect() {
    return perfect;
  }

  /** How many messages found no place in their sender's queue so far. */
  public long dropped() {
    return LongStream.of(dropped).sum();
  }

  /**
   * A camera sends a message now. It waits until those before it are sent, as many bits a step as
   * the bandwidth; where more would wait than the queue holds, it is dropped.
   *
   * @param bits its length, 0 or more
   * @return whether it is sent
   */
  public boolean send(int from, long bits) {
    long now = stations.step();
    long passed = now - steps[from];
    numbers[from] = passed == 0 ? numbers[from] + 1 : 0;
    steps[from] = now;
    return model.bandwidth() == 0 || queue(from, bits, passed);
  }

  private boolean queue(int from, long bits, long passed) {
    long before = Math.max(0, waiting[from] - passed * model.bandwidth());
    boolean fits = before + bits <= model.bandwidth() + model.queue();
    waiting[from] = fits ? before + bits : before;
    waits[from] = (int) (Math.max(0, before + bits - 1) / model.bandwidth());
    dropped[from] += fits ? 0 : 1;
    return fits;
  }

  /**
   * How many steps the copy of the message that a camera {@link #send sent} last takes to another
   * one, 0 for one that arrives in this step; or {@link #LOST}.
   */
  public int delay(int from, int to) {
    int wait = waits[from];
    int way = radio == null ? hop(from, from, to, wait) : way(from, to, wait);
    return way == LOST ? LOST : wait + way;
  }

  /** Over all hops; the time of a hop is that of those before it. */
  private int way(int from, int to, int wait) {
    int last = radio.before(from, to);
    int before = last == from || last == LOST ? 0 : way(from, last, wait);
    if (last == LOST || before == LOST) {
      return LOST;
    }
    int hop = hop(from, last, to, wait + before);
    return hop == LOST ? LOST : before + hop;
  }

  private int hop(int from, int last, int to, int after) {
    long step = steps[from] + after;
    long link = Draw.key(start, ((long) last << 32) | to);
    long message = Draw.key(Draw.key(Draw.key(~link, step), from), numbers[from]);
    return model.loss().loses(link, step, Draw.unit(message))
        ? LOST
        : model.delay().steps(Draw.unit(Draw.key(message, 1)));
  }
}
