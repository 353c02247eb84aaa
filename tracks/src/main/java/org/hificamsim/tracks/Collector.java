package org.hificamsim.tracks;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.hificamsim.tracks.RecordedTarget.Sample;
import org.hificamsim.tracks.format.SampleSink;
import org.hificamsim.tracks.format.TrackSample;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Ground;

/** Converts the samples of a file to metres on the ground, and collects them by target. */
final class Collector implements SampleSink {
  private static final Pattern WHOLE_NUMBER = Pattern.compile("-?(0|[1-9][0-9]{0,14})");

  private final Function<Unit, Ground> groundOf;
  private Ground ground;
  private final Map<String, RecordedTarget> targets = new LinkedHashMap<>();
  private long duplicates;
  private String firstDuplicate = "";

  /**
   * @param groundOf returns what converts the samples of a unit to metres
   */
  Collector(Function<Unit, Ground> groundOf) {
    this.groundOf = groundOf;
  }

  @Override
  public void measuredIn(Unit unit) {
    ground = groundOf.apply(unit);
  }

  @Override
  public void accept(TrackSample fileSample) {
    TrackSample sample = ground.onGround(fileSample);
    if (!targets.computeIfAbsent(sample.target(), RecordedTarget::new).add(sample)) {
      firstDuplicate = duplicates++ == 0 ? sample.place().toString() : firstDuplicate;
    }
  }

  /** The targets in the order of their first samples in the file. */
  Collection<RecordedTarget> targets() {
    return targets.values();
  }

  /** Whether the names of all targets are whole numbers, so that a scenario can use them. */
  boolean hasNumericNames() {
    return targets.keySet().stream().allMatch(name -> WHOLE_NUMBER.matcher(name).matches());
  }

  /** The number of samples that repeat the one before. */
  long duplicates() {
    return duplicates;
  }

  /** The place of the first such sample; empty if there is none. */
  String firstDuplicate() {
    return firstDuplicate;
  }

  /** The time of the first sample, ticks. */
  double firstTick() {
    return targets().stream().mapToDouble(target -> target.samples().get(0).time()).min().orElse(0);
  }

  /** The most frequent number of ticks between samples of a target; 1 if no target has two. */
  double spacing() {
    Map<Double, Long> counts = new TreeMap<>();
    for (RecordedTarget target : targets()) {
      List<Sample> samples = target.samples();
      for (int i = 1; i < samples.size(); i++) {
        double spacing = samples.get(i).time() - samples.get(i - 1).time();
        counts.merge(Math.rint(spacing * 1e6) / 1e6, 1L, Long::sum);
      }
    }
    return counts.entrySet().stream()
        .max(Map.Entry.comparingByValue())
        .map(Map.Entry::getKey)
        .orElse(1.0);
  }
}
