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

/** Takes a file's samples to the ground, and keeps them by target. */
final class Collector implements SampleSink {
  private static final Pattern WHOLE = Pattern.compile("-?(0|[1-9][0-9]{0,14})");

  private final Function<Unit, Ground> grounds;
  private Ground ground;
  private final Map<String, RecordedTarget> targets = new LinkedHashMap<>();
  private long duplicates;
  private String firstDuplicate = "";

  /**
   * @param grounds what takes the samples of a unit to metres
   */
  Collector(Function<Unit, Ground> grounds) {
    this.grounds = grounds;
  }

  @Override
  public void measuredIn(Unit unit) {
    ground = grounds.apply(unit);
  }

  @Override
  public void accept(TrackSample asRead) {
    TrackSample sample = ground.onGround(asRead);
    if (!targets.computeIfAbsent(sample.target(), RecordedTarget::new).add(sample)) {
      firstDuplicate = duplicates++ == 0 ? sample.place().toString() : firstDuplicate;
    }
  }

  /** The targets in the order in which they appear in the file. */
  Collection<RecordedTarget> targets() {
    return targets.values();
  }

  /** Whether the names of all targets are whole numbers, by which a scenario knows them then. */
  boolean ownNames() {
    return targets.keySet().stream().allMatch(name -> WHOLE.matcher(name).matches());
  }

  /** How many samples were there twice, the same each time. */
  long duplicates() {
    return duplicates;
  }

  /** Where the first of them is. */
  String firstDuplicate() {
    return firstDuplicate;
  }

  /** When the first sample was taken, ticks. */
  double firstTick() {
    return targets().stream().mapToDouble(one -> one.samples().get(0).time()).min().orElse(0);
  }

  /** How many ticks lie between two samples of a target most often; 1 where none has two. */
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
