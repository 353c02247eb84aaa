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
 * @param targets one target or more
 * @param secondsPerTick the unit of the targets' times
 * @param notes the oddities of the files
 */
record RecordedTargets(
    Collection<RecordedTarget> targets, double secondsPerTick, ReadingNotes notes) {
  private static final Pattern WHOLE_NUMBER = Pattern.compile("-?(0|[1-9][0-9]{0,14})");

  /** The least share of the most frequent spacing to be the usual one; otherwise the median is. */
  private static final double USUAL_SHARE = 0.1;

  /** Whether the names of all targets are whole numbers, so that a scenario can use them. */
  boolean haveNumericNames() {
    return targets.stream().allMatch(target -> WHOLE_NUMBER.matcher(target.name()).matches());
  }

  /** The time of the first sample, ticks. */
  double firstTick() {
    return targets.stream().mapToDouble(RecordedTarget::firstTime).min().orElse(0);
  }

  /** The usual time between samples, in seconds. */
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
    long total = 0;
    // Most spacings are equal to the one before, so we count runs of equal ones.
    double last = Double.NaN;
    long runLength = 0;
    for (RecordedTarget target : targets) {
      List<Sample> samples = target.samples();
      for (int i = 1; i < samples.size(); i++) {
        double exact = samples.get(i).time() - samples.get(i - 1).time();
        double spacing = Math.rint(exact * 1e6) / 1e6;
        if (spacing != last && runLength > 0) {
          counts.merge(last, runLength, Long::sum);
          runLength = 0;
        }
        last = spacing;
        runLength++;
        total++;
      }
    }
    if (runLength > 0) {
      counts.merge(last, runLength, Long::sum);
    }
    long least = (long) Math.ceil(USUAL_SHARE * total);
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
                  double[] repeated = new double[Math.toIntExact(entry.getValue())];
                  Arrays.fill(repeated, entry.getKey());
                  return Arrays.stream(repeated);
                })
            .toArray();
    return spacings.length == 0 ? 1 : spacings[spacings.length / 2];
  }
}
