package org.hificamsim.tracks;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.tracks.Collector.TargetRecord;
import org.hificamsim.tracks.Jumps.Speeds;

/** What an import found: extent in time and place, speeds, gaps, and what is odd. */
public final class ImportSummary {
  private static final MathContext FOUR = new MathContext(4);

  private final Collector collected;
  private final double interval;
  private final double gap;
  private final Obstacles obstacles;
  private final DoubleSummaryStatistics times = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics xs = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics ys = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics gaps = new DoubleSummaryStatistics();
  private final Speeds speeds = new Speeds();
  private final Jumps jumps = new Jumps();
  private int targets;
  private int single;
  private long blocked; // ways between two samples
  private String firstBlocked = "";

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

  /** Adds a sample. */
  void sample(double time, double x, double y) {
    times.accept(time);
    xs.accept(x);
    ys.accept(y);
  }

  /** Adds the way between two samples of a target, which ends at this time. */
  void leg(TargetRecord target, double time, double duration, Point from, Point to) {
    double way = Math.hypot(to.x() - from.x(), to.y() - from.y());
    if (!obstacles.isEmpty()
        && !obstacles.clear(from.x(), from.y(), to.x(), to.y())
        && blocked++ == 0) {
      firstBlocked = "target " + target.name() + " at " + time + " s";
    }
    double speed = way / duration;
    speeds.add(speed);
    jumps.add(new Jumps.Leg(target.name(), time, way, speed));
  }

  /** Adds a time between two samples that ends a track, seconds. */
  void gap(double duration) {
    jumps.endTrack();
    gaps.accept(duration);
  }

  /**
   * Ends a target.
   *
   * @param samples how many of it were written
   */
  void endTarget(long samples) {
    jumps.endTrack();
    targets += samples > 0 ? 1 : 0;
    single += samples == 1 ? 1 : 0;
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
    List<String> odd = new ArrayList<>(jumps.lines(speeds.quantile(0.75)));
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
      lines.add(line("nobody before %s s: --from leaves that out", times.getMin()));
    }
    lines.add(line("a sample every %s s (%s a second)", interval, 1 / interval));
    lines.add(
        line(
            "speeds: a quarter up to %s m/s, half up to %s, three quarters up to %s",
            speeds.quantile(0.25), speeds.quantile(0.5), speeds.quantile(0.75)));
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
  static String rounded(double value) {
    if (!Double.isFinite(value)) {
      return "-";
    }
    String plain = new BigDecimal(value).round(FOUR).toPlainString();
    return plain.contains(".") ? plain.replaceFirst("\\.?0+$", "") : plain;
  }
}
