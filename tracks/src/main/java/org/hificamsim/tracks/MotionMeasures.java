package org.hificamsim.tracks;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.DoubleStream;
import org.hificamsim.tracks.RecordedTarget.Sample;

/**
 * Measures of how the targets of a recording move, before positions are rounded.
 *
 * @param targets the number of targets
 * @param firstTick the time of the first sample in the units of its file
 * @param interval the usual time between two samples of a target, in seconds
 * @param speeds the speeds of moves to another place, in ascending order, in metres per second
 * @param moves the number of moves, with those to the same place
 * @param least the position with the least x and y of all, in metres
 * @param greatest the position with the greatest x and y of all, in metres
 * @param flags the values of x and y if they are few whole numbers; else empty
 */
record MotionMeasures(
    int targets,
    double firstTick,
    double interval,
    double[] speeds,
    long moves,
    double[] least,
    double[] greatest,
    Set<Long> flags) {
  private static final int MAX_FLAGS = 2;

  /** The greatest number of moves that are measured; of more moves, an even selection is. */
  private static final long MAX_SPEEDS = 50_000;

  /** Measures the targets of a recording. */
  static MotionMeasures of(RecordedTargets recorded, double interval) {
    Values xs = new Values();
    Values ys = new Values();
    DoubleStream.Builder speeds = DoubleStream.builder();
    long moves = 0;
    long stride = 1 + recorded.samples() / MAX_SPEEDS;
    for (RecordedTarget target : recorded.targets()) {
      List<Sample> samples = target.samples();
      for (int i = 0; i < samples.size(); i++) {
        xs.add(samples.get(i).x());
        ys.add(samples.get(i).y());
        boolean isMeasured = i > 0 && moves++ % stride == 0;
        double speed = isMeasured ? speed(samples.get(i - 1), samples.get(i)) : 0;
        if (speed > 0) {
          speeds.add(speed / recorded.secondsPerTick());
        }
      }
    }
    double[] sorted = speeds.build().sorted().toArray();
    Set<Long> flags = new TreeSet<>();
    if (xs.areFlags() && ys.areFlags()) {
      xs.distinct.forEach(value -> flags.add(value.longValue()));
      ys.distinct.forEach(value -> flags.add(value.longValue()));
    }
    return new MotionMeasures(
        recorded.targets().size(),
        recorded.firstTick(),
        interval,
        sorted,
        moves,
        new double[] {xs.least, ys.least},
        new double[] {xs.greatest, ys.greatest},
        flags);
  }

  private static double speed(Sample from, Sample to) {
    return Math.hypot(to.x() - from.x(), to.y() - from.y()) / (to.time() - from.time());
  }

  /** The speed that a share of all moves to another place does not exceed; NaN without any. */
  double quantile(double share) {
    return quantile(speeds, share);
  }

  /** The value that a share of some sorted values does not exceed; NaN if there are none. */
  static double quantile(double[] sorted, double share) {
    return sorted.length == 0
        ? Double.NaN
        : sorted[Math.max(0, (int) Math.ceil(share * sorted.length) - 1)];
  }

  /** The longer side of the rectangle around all positions, in metres. */
  double extent() {
    return Math.max(greatest[0] - least[0], greatest[1] - least[1]);
  }

  /** Whether all positions could be degrees of longitude and latitude. */
  boolean isWithinDegrees() {
    return least[0] >= -180 && greatest[0] <= 180 && least[1] >= -90 && greatest[1] <= 90;
  }

  /** The values of one coordinate. */
  private static final class Values {
    private double least = Double.POSITIVE_INFINITY;
    private double greatest = Double.NEGATIVE_INFINITY;
    private final Set<Double> distinct = new HashSet<>();

    void add(double value) {
      least = Math.min(least, value);
      greatest = Math.max(greatest, value);
      if (distinct.size() <= MAX_FLAGS) {
        distinct.add(value);
      }
    }

    boolean areFlags() {
      return distinct.size() <= MAX_FLAGS
          && distinct.stream().allMatch(value -> value == Math.rint(value));
    }
  }
}
