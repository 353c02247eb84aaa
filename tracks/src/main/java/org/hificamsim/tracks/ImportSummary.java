package org.hificamsim.tracks;

import static java.util.stream.Collectors.summarizingDouble;

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
import org.hificamsim.tracks.place.PeoplePositions;

/** The findings of an import: the extent in time and space, speeds, gaps, and oddities. */
public final class ImportSummary {
  private static final MathContext FOUR_DIGITS = new MathContext(4);
  private static final String JUMP = "target %s jumps %s m before %s s, %s m/s";

  /** The least factor by which a jump is faster than usual. */
  private static final double JUMP_FACTOR = 5;

  /** The least usual speed, in metres per second, even if all targets stand still. */
  private static final double MIN_SPEED = 0.1;

  /** The unit to which quantiles are rounded, in metres per second. */
  private static final double SPEED_STEP = 0.01;

  private static final int MAX_LISTED_JUMPS = 3;

  private final RecordedTargets recorded;
  private final double interval;
  private final double gap;
  private final Obstacles obstacles;
  private final DoubleSummaryStatistics times = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics xs = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics ys = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics gaps = new DoubleSummaryStatistics();
  private final DoubleSummaryStatistics pauses = new DoubleSummaryStatistics();
  private final DoubleStream.Builder allSpeeds = DoubleStream.builder();
  private double[] sortedSpeeds; // null until all targets have been added
  private final List<Move> fastMoves = new ArrayList<>();
  private int targets;
  private int singleSampleTargets;
  private long moves;
  private long blockedMoves;
  private int movingTargets;
  private int blockedTargets;
  private final PeoplePositions positions = new PeoplePositions();
  private String firstBlocked = "";

  /**
   * A target's move between two samples.
   *
   * @param time when the move ends, in seconds
   * @param length the length in metres
   * @param speed the speed in metres per second
   */
  private record Move(String target, double time, double length, double speed) {}

  /**
   * @param interval usual time between two samples of a target, in seconds
   * @param gap the longest time between two samples of a target that is present meanwhile, in
   *     seconds
   * @param obstacles obstacles; the summary reports tracks that pass through them
   */
  ImportSummary(RecordedTargets recorded, double interval, double gap, Obstacles obstacles) {
    this.recorded = recorded;
    this.interval = interval;
    this.gap = gap;
    this.obstacles = obstacles;
  }

  /**
   * Adds the next target of the recording.
   *
   * @param tracks tracks of the target; may be empty
   */
  void add(String target, List<List<Sample>> tracks) {
    Sample last = null;
    int samples = 0;
    long movesBefore = moves;
    long blockedBefore = blockedMoves;
    for (List<Sample> track : tracks) {
      if (last != null) {
        double absence = track.get(0).time() - last.time();
        (absence > gap ? gaps : pauses).accept(absence);
      }
      for (Sample sample : track) {
        times.accept(sample.time());
        xs.accept(sample.x());
        ys.accept(sample.y());
        positions.add(sample.x(), sample.y());
      }
      addMoves(target, track);
      samples += track.size();
      last = track.get(track.size() - 1);
    }
    targets += samples > 0 ? 1 : 0;
    movingTargets += moves > movesBefore ? 1 : 0;
    blockedTargets += blockedMoves > blockedBefore ? 1 : 0;
    singleSampleTargets += samples == 1 ? 1 : 0;
  }

  private void addMoves(String target, List<Sample> track) {
    List<Move> moves = new ArrayList<>();
    Obstacles near = obstaclesNear(track);
    for (int i = 1; i < track.size(); i++) {
      Sample from = track.get(i - 1);
      Sample to = track.get(i);
      double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
      double speed = length / (to.time() - from.time());
      moves.add(new Move(target, to.time(), length, speed));
      allSpeeds.add(speed);
      this.moves++;
      if (!near.clear(from.x(), from.y(), to.x(), to.y()) && blockedMoves++ == 0) {
        firstBlocked = "target " + target + " at " + to.time() + " s";
      }
    }
    for (int i = 0; i < moves.size(); i++) {
      if (moves.get(i).speed > JUMP_FACTOR * slowerNeighbour(moves, i)) {
        fastMoves.add(moves.get(i));
      }
    }
  }

  /** The obstacles near a track, so that not all are compared with each move. */
  private Obstacles obstaclesNear(List<Sample> track) {
    if (obstacles.isEmpty()) {
      return obstacles;
    }
    DoubleSummaryStatistics x = track.stream().collect(summarizingDouble(Sample::x));
    DoubleSummaryStatistics y = track.stream().collect(summarizingDouble(Sample::y));
    return obstacles.near(x.getMin(), y.getMin(), x.getMax(), y.getMax());
  }

  /** The speed of the slower of the moves before and after a move; 0 if there are none. */
  private static double slowerNeighbour(List<Move> moves, int i) {
    return Stream.of(i - 1, i + 1)
        .filter(neighbour -> neighbour >= 0 && neighbour < moves.size())
        .mapToDouble(neighbour -> moves.get(neighbour).speed)
        .min()
        .orElse(0);
  }

  /**
   * The speed that this share of all moves does not exceed, rounded to a centimetre per second; NaN
   * if there are no moves.
   */
  double quantile(double share) {
    sortedSpeeds = sortedSpeeds == null ? allSpeeds.build().sorted().toArray() : sortedSpeeds;
    return Math.rint(MotionMeasures.quantile(sortedSpeeds, share) / SPEED_STEP) * SPEED_STEP;
  }

  /**
   * Describes jumps: moves that are five times as fast as the slower of the moves before and after
   * them, and five times as fast as three quarters of all moves. A car that keeps driving is fast
   * but does not jump.
   */
  private List<String> jumps() {
    double usual = quantile(0.75);
    double limit = JUMP_FACTOR * Math.max(MIN_SPEED, Double.isNaN(usual) ? 0 : usual);
    List<Move> jumps = fastMoves.stream().filter(move -> move.speed > limit).toList();
    List<String> lines = new ArrayList<>();
    if (!jumps.isEmpty()) {
      lines.add(line("%s jumps, faster than %s m/s", jumps.size(), limit));
      jumps.stream()
          .sorted(Comparator.comparingDouble(Move::speed).reversed())
          .limit(MAX_LISTED_JUMPS)
          .map(move -> line(JUMP, move.target, move.length, move.time, move.speed))
          .forEach(lines::add);
    }
    return lines;
  }

  /** The number of targets with samples. */
  public int targets() {
    return targets;
  }

  /** The number of samples that were written. */
  long samples() {
    return times.getCount();
  }

  /** The usual time between two samples of a target, in seconds. */
  double interval() {
    return interval;
  }

  /** The time of the last sample, in seconds from the start. */
  double duration() {
    return times.getMax();
  }

  /** The longest time between two samples of a target that is present meanwhile, in seconds. */
  double gap() {
    return gap;
  }

  /** The bounding box of all samples, in metres. */
  Field box() {
    return new Field(xs.getMin(), xs.getMax(), ys.getMin(), ys.getMax());
  }

  /** The positions of all samples, thinned out. */
  PeoplePositions positions() {
    return positions;
  }

  /**
   * Whether the tracks of all targets go through a wall. A single crossing by a single target does
   * not count: one sample may be off.
   */
  boolean isEveryTrackBlocked() {
    return blockedTargets > 0
        && blockedTargets == movingTargets
        && (movingTargets > 1 || 2 * blockedMoves > moves);
  }

  /** Finds signs that positions or times were read in another unit than they have. */
  MotionSigns motionSigns() {
    return new MotionSigns(MotionMeasures.of(recorded, interval), recorded.notes().unit());
  }

  /** The oddities of the files. */
  ReadingNotes notes() {
    return recorded.notes();
  }

  /** The number of targets whose size the file has. */
  public long targetsWithSize() {
    return recorded.withSize();
  }

  /** Describes what is odd, in lines. */
  List<String> oddities() {
    List<String> oddities = jumps();
    if (singleSampleTargets > 0) {
      oddities.add(singleSampleTargets + " targets with one sample alone");
    }
    if (blockedMoves > 0) {
      String times = blockedMoves == 1 ? "once, " : blockedMoves + " times, first ";
      oddities.add("through a wall: " + times + firstBlocked);
    }
    oddities.addAll(recorded.notes().duplicateLines());
    return oddities;
  }

  /** The whole summary, in lines for people. */
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
    if (pauses.getCount() > 0) {
      lines.add(
          line(
              "%s shorter pauses between the parts of a track: the target is away meanwhile",
              pauses.getCount()));
    }
    MathContext digits = digitsOfPositions();
    lines.add(
        "places: x from %s to %s m, y from %s to %s m"
            .formatted(
                rounded(xs.getMin(), digits),
                rounded(xs.getMax(), digits),
                rounded(ys.getMin(), digits),
                rounded(ys.getMax(), digits)));
    lines.addAll(recorded.notes().lines());
    lines.addAll(recorded.notes().leftOut().lines());
    oddities().forEach(oddity -> lines.add("odd: " + oddity));
    return lines;
  }

  /** The digits that distinguish positions; far from the origin of a map they need more. */
  private MathContext digitsOfPositions() {
    Field box = box();
    double far =
        Math.max(
            Math.max(Math.abs(box.minX()), Math.abs(box.maxX())),
            Math.max(Math.abs(box.minY()), Math.abs(box.maxY())));
    double near = Math.max(1, Math.max(box.width(), box.height()));
    int more = (int) Math.ceil(Math.log10(Math.max(1, far / near)));
    return new MathContext(FOUR_DIGITS.getPrecision() + Math.max(0, more - 1));
  }

  /** Formats a line; floating-point numbers are rounded. */
  private static String line(String pattern, Object... values) {
    return pattern.formatted(
        Stream.of(values)
            .map(value -> value instanceof Double number ? rounded(number, FOUR_DIGITS) : value)
            .toArray());
  }

  /** Rounds without an exponent and without trailing zeros. */
  private static String rounded(double value, MathContext digits) {
    if (!Double.isFinite(value)) {
      return "-";
    }
    String plain = new BigDecimal(value).round(digits).toPlainString();
    return plain.contains(".") ? plain.replaceFirst("\\.?0+$", "") : plain;
  }
}
