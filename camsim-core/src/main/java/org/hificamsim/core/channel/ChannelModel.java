package org.hificamsim.core.channel;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.registry.Options;

/**
 * The delays and losses of messages between cameras: the setting {@code channel} ({@code
 * docs/channel.md}). A {@link Channel} applies it in a run.
 */
public final class ChannelModel {
  /** An example for help. */
  public static final String EXAMPLE = "loss=0.2,delay=2,range=30,bandwidth=1000";

  /** The channel that delivers everything at once. */
  public static final ChannelModel PERFECT = parse("perfect");

  private static final double MAX_RANGE = 1e9;
  private static final int MAX_BITS = 1_000_000_000;

  private final Loss loss;
  private final Delay delay;
  private final double range;
  private final int bandwidth;
  private final int queue;

  private ChannelModel(Options options) {
    loss = Loss.from(options);
    delay = Delay.from(options);
    range =
        options.number("range", 0, 0, MAX_RANGE, "metres of a radio, farther over others; 0: any");
    bandwidth = options.integer("bandwidth", 0, 0, MAX_BITS, "bits a step a camera sends; 0: any");
    queue =
        options.integer(
            "queue", 10, 1, 10_000, "steps of sending that wait at most; more is dropped");
  }

  /**
   * Parses {@code perfect} or {@code key=value,...}.
   *
   * @throws org.hificamsim.core.InputException if an option is invalid
   */
  public static ChannelModel parse(String text) {
    Options options =
        text.equals("perfect") ? Options.none("channel") : Options.parse("channel", text);
    ChannelModel model = new ChannelModel(options);
    options.rejectUnknown();
    return model;
  }

  /** The model as users write it, with the options that differ from their defaults. */
  public String text() {
    String given =
        Stream.of(
                loss.text(),
                delay.isNone() ? "" : "delay=" + delay.text(),
                option("range", range, 0),
                option("bandwidth", bandwidth, 0),
                bandwidth == 0 ? "" : option("queue", queue, 10))
            .filter(option -> !option.isEmpty())
            .collect(Collectors.joining(","));
    return given.isEmpty() ? "perfect" : given;
  }

  static String option(String key, double value, double fallback) {
    String number =
        value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    return value == fallback ? "" : key + "=" + number;
  }

  /** Whether everything arrives at once. */
  public boolean isPerfect() {
    return loss.isNone() && delay.isNone() && range == 0 && bandwidth == 0;
  }

  Loss loss() {
    return loss;
  }

  Delay delay() {
    return delay;
  }

  /** The range of a radio, in metres; 0 if all cameras reach each other. */
  double range() {
    return range;
  }

  /** The number of bits that a camera can send in a step; 0 for no limit. */
  long bandwidth() {
    return bandwidth;
  }

  /** The number of bits that may wait in a camera's queue. */
  long queue() {
    return (long) queue * bandwidth;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ChannelModel model && text().equals(model.text());
  }

  @Override
  public int hashCode() {
    return text().hashCode();
  }
}
