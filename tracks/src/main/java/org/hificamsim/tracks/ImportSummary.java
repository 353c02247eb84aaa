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
  public long samples() {
    return times.getCount();
  }

  /** Between most samples of a target, seconds. */
  public double interval() {
    return interval;
  }

  /** The longest time between two samples of a target that is present in between, seconds. */
  public double gap() {
    return gap;
  }

  /** How many longer ones there are. */
  public long gaps() {
    return gaps.getCount();
  }

  /** The longest of them, seconds. */
  public double longestGap() {
    return gaps.getMax();
  }

  /** The quartiles of the speeds between two samples, metres a second. */
  public List<Double> speeds() {
    return Stream.of(0.25, 0.5, 0.75).map(speeds::quantile).toList();
  }

  /** What holds all samples, metres. */
  public Field box() {
    return new Field(xs.getMin(), xs.getMax(), ys.getMin(), ys.getMax());
  }

  /** Whether targets are known by the names that the file has. */
  public boolean ownNames() {
    return collected.ownNames();
  }

  /** Of how many targets the file says the size. */
  public long sized() {
    return collected.targets().stream().filter(one -> one.extent().isPresent()).count();
  }

  /** What is odd, in lines. */
  public List<String> odd() {
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
    lines.add(
        "%s targets, %s samples, %s s".formatted(targets, samples(), rounded(times.getMax())));
    lines.add(
        "a sample every %s s (%s a second)".formatted(rounded(interval), rounded(1 / interval)));
    lines.add(
        "speeds: a quarter up to %s m/s, half up to %s, three quarters up to %s"
            .formatted(rounded(speeds().stream())));
    lines.add(
        gaps() == 0
            ? "no gap longer than %s s".formatted(rounded(gap))
            : "%s gaps longer than %s s, up to %s s: the target is away meanwhile"
                .formatted(gaps(), rounded(gap), rounded(longestGap())));
    lines.add(
        "places: x from %s to %s m, y from %s to %s m"
            .formatted(rounded(Stream.of(xs.getMin(), xs.getMax(), ys.getMin(), ys.getMax()))));
    odd().forEach(one -> lines.add("odd: " + one));
    return lines;
  }

  private static Object[] rounded(Stream<Double> values) {
    return values.map(ImportSummary::rounded).toArray();
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
