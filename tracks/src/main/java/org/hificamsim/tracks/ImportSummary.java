package org.hificamsim.tracks;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.RecordedTarget.Sample;

/** What an import found: extent in time and place, speeds, gaps, and what is odd. */
public final class ImportSummary {
  private static final MathContext FOUR = new MathContext(4);
  private static final String JUMP = "target %s jumps %s m before %s s, %s m/s";
  private static final double ODD = 5;
  private static final double LEAST = 0.1; // m/s: of targets that all stand
  private static final double STEP = 0.01; // m/s
  private static final int NAMED = 3; // jumps that are listed one by one

  private final Collector collected;
  private final double interval;
  private final double gap;
  private final Obstacles obstacles;
  private final DoubleSummaryStatistics times = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics xs = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics ys = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics gaps = new DoubleSummaryStatistics();
  private final DoubleStream.Builder allSpeeds = DoubleStream.builder();
  private double[] speeds; // sorted, once they are all there
  private final List<Way> fast = new ArrayList<>();
  private int targets;
  private int single;
  private long blocked; // ways between two samples
  private String firstBlocked = "";

  /** The way between two samples of a target, which ends at a time; metres, metres per second. */
  private record Way(String target, double time, double length, double speed) {}

  /**
   * @param interval between most samples of a target, seconds
   * @param gap the longest time between two samples of a target that is present in between, seconds
   * @param obstacles through which nobody should go
   */
  ImportSummary(Collector collected, double interval, double gap, Obstacles obstacles) {
    this.collected = collected;
    this.interval = interval;
    this.gap = gap;
    this.obstacles = obstacles;
  }

  /**
   * Adds a target, the next one of the recording.
   *
   * @param tracks of it, perhaps none
   */
  void add(String target, List<List<Sample>> tracks) {
    Sample last = null;
    int samples = 0;
    for (List<Sample> track : tracks) {
      if (last != null) {
        gaps.accept(track.get(0).time() - last.time());
      }
      for (Sample sample : track) {
        times.accept(sample.time());
        xs.accept(sample.x());
        ys.accept(sample.y());
      }
      addWays(target, track);
      samples += track.size();
      last = track.get(track.size() - 1);
    }
    targets += samples > 0 ? 1 : 0;
    single += samples == 1 ? 1 : 0;
  }

  private void addWays(String target, List<Sample> track) {
    List<Way> ways = new ArrayList<>();
    for (int i = 1; i < track.size(); i++) {
      Sample from = track.get(i - 1);
      Sample to = track.get(i);
      double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
      double speed = length / (to.time() - from.time());
      ways.add(new Way(target, to.time(), length, speed));
      allSpeeds.add(speed);
      if (!obstacles.isEmpty()
          && !obstacles.clear(from.x(), from.y(), to.x(), to.y())
          && blocked++ == 0) {
        firstBlocked = "target " + target + " at " + to.time() + " s";
      }
    }
    for (int i = 0; i < ways.size(); i++) {
      if (ways.get(i).speed > ODD * slowerAround(ways, i)) {
        fast.add(ways.get(i));
      }
    }
  }

  /** The speed of the slower of the ways before and after one; 0 where there are none. */
  private static double slowerAround(List<Way> ways, int i) {
    return Stream.of(i - 1, i + 1)
        .filter(other -> other >= 0 && other < ways.size())
        .mapToDouble(other -> ways.get(other).speed)
        .min()
        .orElse(0);
  }

  /** The speed that this part of all is not above, to the centimetre; NaN where there is none. */
  double quantile(double part) {
    speeds = speeds == null ? allSpeeds.build().sorted().toArray() : speeds;
    int last = (int) Math.ceil(part * speeds.length) - 1;
    return speeds.length == 0 ? Double.NaN : Math.rint(speeds[Math.max(0, last)] / STEP) * STEP;
  }

  /**
   * Where targets jump: ways that are five times as fast as the slower of the ways before and after
   * them, and as three quarters of all ways. A car that drives on is fast and does not jump.
   */
  private List<String> jumps() {
    double usual = quantile(0.75);
    double limit = ODD * Math.max(LEAST, Double.isNaN(usual) ? 0 : usual);
    List<Way> jumps = fast.stream().filter(way -> way.speed > limit).toList();
    List<String> lines = new ArrayList<>();
    if (!jumps.isEmpty()) {
      lines.add(line("%s jumps, faster than %s m/s", jumps.size(), limit));
      jumps.stream()
          .sorted(Comparator.comparingDouble(Way::speed).reversed())
          .limit(NAMED)
          .map(way -> line(JUMP, way.target, way.length, way.time, way.speed))
          .forEach(lines::add);
    }
    return lines;
  }

  /** How many targets. */
  public int targets() {
    return targets;
  }

  /** How many samples were written. */
  long samples() {
    return times.getCount();
  }

  /** Between most samples of a target, seconds. */
  double interval() {
    return interval;
  }

  /** When the last sample is, seconds from the start. */
  double duration() {
    return times.getMax();
  }

  /** The longest time between two samples of a target that is present in between, seconds. */
  double gap() {
    return gap;
  }

  /** What holds all samples, metres. */
  Field box() {
    return new Field(xs.getMin(), xs.getMax(), ys.getMin(), ys.getMax());
  }

  /** Of how many targets the file says the size. */
  public long sized() {
    return collected.targets().stream().filter(one -> one.extent().isPresent()).count();
  }

  /** What is odd, in lines. */
  List<String> odd() {
    List<String> odd = jumps();
    if (single > 0) {
      odd.add(single + " targets with one sample alone");
    }
    if (blocked > 0) {
      String times = blocked == 1 ? "once, " : blocked + " times, first ";
      odd.add("through a wall: " + times + firstBlocked);
    }
    if (collected.duplicates() > 0) {
      odd.add(
          collected.duplicates()
              + " samples are there twice and count once, the first at "
              + collected.firstDuplicate());
    }
    return odd;
  }

  /** All of it, in lines for people. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(line("%s samples of %s targets in %s s", samples(), targets, duration()));
    if (times.getMin() > gap) {
      lines.add(line("nobody before %s s: a later start leaves that out", times.getMin()));
    }
    lines.add(line("a sample every %s s (%s a second)", interval, 1 / interval));
    lines.add(
        line(
            "speeds: a quarter up to %s m/s, half up to %s, three quarters up to %s",
            quantile(0.25), quantile(0.5), quantile(0.75)));
    lines.add(
        gaps.getCount() == 0
            ? line("no gap longer than %s s", gap)
            : line(
                "%s gaps longer than %s s, up to %s s: the target is away meanwhile",
                gaps.getCount(), gap, gaps.getMax()));
    lines.add(
        line(
            "places: x from %s to %s m, y from %s to %s m",
            xs.getMin(), xs.getMax(), ys.getMin(), ys.getMax()));
    odd().forEach(one -> lines.add("odd: " + one));
    return lines;
  }

  /** A line whose floating numbers are rounded. */
  private static String line(String pattern, Object... values) {
    return pattern.formatted(
        Stream.of(values)
            .map(value -> value instanceof Double number ? rounded(number) : value)
            .toArray());
  }

  /** Four digits, without an exponent or zeros at the end. */
  private static String rounded(double value) {
    if (!Double.isFinite(value)) {
      return "-";
    }
    String plain = new BigDecimal(value).round(FOUR).toPlainString();
    return plain.contains(".") ? plain.replaceFirst("\\.?0+$", "") : plain;
  }
}
