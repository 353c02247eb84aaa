package org.hificamsim.tracks;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.hificamsim.tracks.RecordedTarget.Sample;

/**
 * The targets of a recording, in the order of their first samples in its files.
 *
 * @param targets one or more
 * @param secondsPerTick the unit of their times
 * @param notes what is odd about the files
 */
record RecordedTargets(
    Collection<RecordedTarget> targets, double secondsPerTick, ReadingNotes notes) {
  private static final Pattern WHOLE_NUMBER = Pattern.compile("-?(0|[1-9][0-9]{0,14})");

  /** A spacing is usual if it has at least this share of all; else the median one is. */
  private static final double USUAL_SHARE = 0.1;

  /** Whether the names of all targets are whole numbers, so that a scenario can use them. */
  boolean haveNumericNames() {
    return targets.stream().allMatch(target -> WHOLE_NUMBER.matcher(target.name()).matches());
  }

  /** The time of the first sample, ticks. */
  double firstTick() {
    return targets.stream().mapToDouble(RecordedTarget::firstTime).min().orElse(0);
  }

  /** The usual time between samples, seconds. */
  double interval() {
    return spacing(targets) * secondsPerTick;
  }

  /** The number of samples. */
  long samples() {
    return targets.stream().mapToLong(target -> target.samples().size()).sum();
  }

  /** The number of targets whose size a file has. */
  long withSize() {
    return targets.stream().filter(target -> target.extent().isPresent()).count();
  }

  /**
   * The most frequent number of ticks between samples of a target, or, if clocks are too irregular
   * for it, the median one; 1 if no target has two samples.
   */
  static double spacing(Collection<RecordedTarget> targets) {
    Map<Double, Long> counts = new TreeMap<>();
    long all = 0;
    double last = Double.NaN; // the spacing before, which most are equal to
    long equal = 0;
    for (RecordedTarget target : targets) {
      List<Sample> samples = target.samples();
      for (int i = 1; i < samples.size(); i++) {
        double exact = samples.get(i).time() - samples.get(i - 1).time();
        double spacing = Math.rint(exact * 1e6) / 1e6;
        if (spacing != last && equal > 0) {
          counts.merge(last, equal, Long::sum);
          equal = 0;
        }
        last = spacing;
        equal++;
        all++;
      }
    }
    if (equal > 0) {
      counts.merge(last, equal, Long::sum);
    }
    long least = (long) Math.ceil(USUAL_SHARE * all);
    return counts.entrySet().stream()
        .max(Map.Entry.comparingByValue())
        .filter(usual -> usual.getValue() >= least)
        .map(Map.Entry::getKey)
        .orElseGet(() -> median(counts));
  }

  private static double median(Map<Double, Long> counts) {
    double[] spacings =
        counts.entrySet().stream()
            .flatMapToDouble(
                entry -> {
                  double[] same = new double[Math.toIntExact(entry.getValue())];
                  Arrays.fill(same, entry.getKey());
                  return Arrays.stream(same);
                })
            .toArray();
    return spacings.length == 0 ? 1 : spacings[spacings.length / 2];
  }
}
