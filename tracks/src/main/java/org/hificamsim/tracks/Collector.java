package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.scenario.Extent;
import org.hificamsim.tracks.format.SampleSink;
import org.hificamsim.tracks.format.TrackSample;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Ground;

/**
 * Takes a file's samples to the ground, checks each against the last one of its target, and stores
 * them. Of each target it keeps one record, whatever the number of samples.
 */
final class Collector implements SampleSink {
  private static final Pattern WHOLE = Pattern.compile("-?(0|[1-9][0-9]{0,14})");
  private static final int MAX_SPACINGS = 1000; // different ones that are counted

  private final SampleStore store;
  private final Function<Unit, Ground> grounds;
  private Ground ground;
  private final Map<String, TargetRecord> byName = new HashMap<>();
  private final List<TargetRecord> targets = new ArrayList<>();
  private final Map<Double, Long> spacings = new TreeMap<>();
  private long duplicates;
  private String firstDuplicate = "";
  private double firstTick = Double.POSITIVE_INFINITY;

  /**
   * @param grounds what takes the samples of a unit to metres
   */
  Collector(SampleStore store, Function<Unit, Ground> grounds) {
    this.store = store;
    this.grounds = grounds;
  }

  @Override
  public void measuredIn(Unit unit) {
    ground = grounds.apply(unit);
  }

  @Override
  public void accept(TrackSample asRead) {
    TrackSample sample = ground.onGround(asRead);
    TargetRecord target = byName.computeIfAbsent(sample.target(), this::begun);
    if (isNew(sample, target)) {
      count(sample, target);
      target.seen(sample);
      Io.run(() -> store.add(target.number(), sample.tick(), sample.x(), sample.y()));
    }
  }

  private TargetRecord begun(String name) {
    TargetRecord target = new TargetRecord(targets.size(), name);
    targets.add(target);
    return target;
  }

  private boolean isNew(TrackSample sample, TargetRecord target) {
    if (sample.tick() > target.tick) {
      return true;
    }
    if (sample.tick() < target.tick) {
      throw fault(
          sample,
          ": time runs backwards, from %s to %s, expected a target's samples in order of time"
              .formatted(target.tick, sample.tick()));
    }
    if (target.x != sample.x() || target.y != sample.y()) {
      throw fault(
          sample,
          " is at two places at time %s, expected one sample of a target at a time"
              .formatted(sample.tick()));
    }
    firstDuplicate = duplicates++ == 0 ? sample.place().toString() : firstDuplicate;
    return false;
  }

  private static InputException fault(TrackSample sample, String problem) {
    return sample.place().error("target " + sample.target() + problem);
  }

  private void count(TrackSample sample, TargetRecord target) {
    firstTick = Math.min(firstTick, sample.tick());
    if (target.tick != Double.NEGATIVE_INFINITY) {
      double spacing = Math.rint((sample.tick() - target.tick) * 1e6) / 1e6;
      if (spacings.size() < MAX_SPACINGS || spacings.containsKey(spacing)) {
        spacings.merge(spacing, 1L, Long::sum);
      }
    }
  }

  /** The targets by number. */
  List<TargetRecord> targets() {
    return targets;
  }

  /** Whether the names of all targets are whole numbers, by which a scenario knows them then. */
  boolean ownNames() {
    return byName.keySet().stream().allMatch(name -> WHOLE.matcher(name).matches());
  }

  /** How many samples were there twice, the same each time. */
  long duplicates() {
    return duplicates;
  }

  /** Where the first of them is. */
  String firstDuplicate() {
    return firstDuplicate;
  }

  /** When the first sample was taken. */
  double firstTick() {
    return firstTick;
  }

  /** How many ticks lie between two samples of a target most often; 1 where none has two. */
  double spacing() {
    double best = 1;
    long most = 0;
    for (Map.Entry<Double, Long> one : spacings.entrySet()) {
      best = one.getValue() > most ? one.getKey() : best;
      most = Math.max(most, one.getValue());
    }
    return best;
  }

  /** What is kept of a target while its file is read. */
  static final class TargetRecord {
    private final int number;
    private final String name;
    private double tick = Double.NEGATIVE_INFINITY; // when it was seen last
    private double x;
    private double y;
    private double widths;
    private double heights;
    private int sized;

    TargetRecord(int number, String name) {
      this.number = number;
      this.name = name;
    }

    /** From 0, in the order in which the targets appear in the file. */
    int number() {
      return number;
    }

    /** As the file says it. */
    String name() {
      return name;
    }

    /** Takes its latest sample. */
    void seen(TrackSample sample) {
      tick = sample.tick();
      x = sample.x();
      y = sample.y();
      if (isLength(sample.width()) && isLength(sample.height())) {
        widths += sample.width();
        heights += sample.height();
        sized++;
      }
    }

    private static boolean isLength(double metres) {
      return metres > 0 && metres <= 1e9;
    }

    /** The mean of its boxes; empty where the file has none. */
    Optional<Extent> extent() {
      return sized == 0
          ? Optional.empty()
          : Optional.of(new Extent(rounded(widths / sized), rounded(heights / sized)));
    }

    private static double rounded(double metres) {
      return Math.max(1e-3, Math.rint(metres * 1000) / 1000);
    }
  }
}
