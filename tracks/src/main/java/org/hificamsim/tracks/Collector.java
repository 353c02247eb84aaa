package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.Clock;
import org.hificamsim.tracks.format.Doubt;
import org.hificamsim.tracks.format.FormatChoice;
import org.hificamsim.tracks.format.Omission;
import org.hificamsim.tracks.format.SampleSink;
import org.hificamsim.tracks.format.TrackSample;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Ground;

/** Converts the samples of a file to metres on the ground, and collects them by target. */
final class Collector implements SampleSink {
  private final Path file;
  private final Function<Unit, Ground> groundFor;
  private final ReadingNotes notes = new ReadingNotes();
  private final Map<String, RecordedTarget> targets = new LinkedHashMap<>();
  private final boolean reusesIds;
  private Ground ground;
  private long fractionalTicks;

  private Collector(FormatChoice choice, Function<Unit, Ground> groundFor) {
    this.file = choice.recording().file();
    this.reusesIds = choice.reader().reusesIds();
    this.groundFor = groundFor;
  }

  /**
   * Reads a file.
   *
   * @param groundFor returns the conversion of a unit to metres
   * @throws InputException if the file is wrong, or has no samples
   */
  static FileTargets read(FormatChoice choice, Function<Unit, Ground> groundFor) {
    Collector collector = new Collector(choice, groundFor);
    Clock clock = choice.read(collector);
    List<RecordedTarget> targets = collector.sorted(choice);
    if (targets.isEmpty()) {
      InputException empty = choice.recording().missing("samples of targets; the file has none");
      throw choice.wrongFormat(collector.notes.leftOut().first().orElse(empty));
    }
    if (clock.countsFrames()
        && 2 * collector.fractionalTicks > collector.notes.leftOut().samples()) {
      collector.doubt(
          new Doubt(
              "most frames are not whole numbers: they are probably seconds",
              setting("rate", "1") + " if they are"));
    }
    return new FileTargets(
        choice.recording().file(),
        choice.reader().hasIds(),
        targets,
        clock.secondsPerTick(() -> RecordedTargets.spacing(targets)),
        collector.notes);
  }

  /** The targets with their samples in the order of time. */
  private List<RecordedTarget> sorted(FormatChoice choice) {
    RowOrder order = new RowOrder(reusesIds);
    try {
      List<RecordedTarget> sorted = order.sort(targets.values());
      order.lines().forEach(notes::addLine);
      order.sign().ifPresent(notes::addDoubt);
      return sorted;
    } catch (InputException fault) {
      throw choice.wrongFormat(fault);
    }
  }

  @Override
  public void measuredIn(Unit unit) {
    ground = groundFor.apply(unit);
    notes.measuredIn(unit);
  }

  @Override
  public void accept(TrackSample fileSample) {
    TrackSample sample = ground.onGround(fileSample);
    if (!targets.computeIfAbsent(sample.target(), RecordedTarget::new).add(sample, reusesIds)) {
      notes.addDuplicate(sample.place());
    }
    notes.leftOut().addSample();
    fractionalTicks += fileSample.tick() == Math.rint(fileSample.tick()) ? 0 : 1;
  }

  @Override
  public void pause(String target) {
    if (targets.containsKey(target)) {
      targets.get(target).pause();
    }
  }

  @Override
  public void leaveOut(Omission kind, Supplier<InputException> reason) {
    notes.leftOut().add(kind, reason);
  }

  @Override
  public void doubt(Doubt sign) {
    notes.addDoubt(new Doubt(file + ": " + sign.problem(), sign.cure()));
  }
}
