package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.tracks.format.Omission;

/**
 * The rows that were left out, by kind. A few odd rows are no reason to refuse a file; many are a
 * sign that it is read in the wrong way.
 */
final class LeftOut {
  /** The number of faulty rows that a file may have, regardless of their share. */
  private static final long FEW = 3;

  /** The greatest share of faulty rows; a file with more of them is rejected. */
  private static final double MAX_SHARE = 0.1;

  /** The number of faulty rows without a sample after which reading stops. */
  private static final long MANY = 10_000;

  private static final class Kind {
    private final InputException first;
    private long count;

    Kind(InputException first) {
      this.first = first;
    }
  }

  private final Map<Omission, Kind> kinds = new EnumMap<>(Omission.class);
  private long samples;
  private long faults;

  /** Counts a row that is a sample. */
  void addSample() {
    samples++;
  }

  /** The number of rows that are samples. */
  long samples() {
    return samples;
  }

  /**
   * Counts a row that is left out.
   *
   * @throws InputException if a file has many of them, and no sample
   */
  void add(Omission omission, Supplier<InputException> reason) {
    kinds.computeIfAbsent(omission, kind -> new Kind(reason.get())).count++;
    faults += omission.isFault() ? 1 : 0;
    if (faults == MANY && samples == 0) {
      throw first().orElseThrow();
    }
  }

  /** Adds what was left out of another file. */
  void combine(LeftOut other) {
    other.kinds.forEach(
        (omission, kind) ->
            kinds.computeIfAbsent(omission, key -> new Kind(kind.first)).count += kind.count);
    samples += other.samples;
    faults += other.faults;
  }

  /** The first row that was left out, of a kind that is a fault if there are any. */
  Optional<InputException> first() {
    return kinds.entrySet().stream()
        .filter(kind -> kind.getKey().isFault() || faults == 0)
        .map(kind -> kind.getValue().first)
        .findFirst();
  }

  /** Adds a sign if more than a tenth of all rows are faulty. */
  void addTo(Plausibility signs) {
    if (faults > Math.max(FEW, MAX_SHARE * (samples + faults))) {
      signs.fault(
          "%s; %s of %s entries are left out"
              .formatted(
                  first().orElseThrow().message(NamedSetting.MARKED), faults, samples + faults),
          "at most a tenth of them");
    }
  }

  /** Describes the omissions, in a line for each kind. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    kinds.forEach(
        (omission, kind) ->
            lines.add(
                "left out: %s %s, the first at %s"
                    .formatted(
                        kind.count == 1 ? "1 entry" : kind.count + " entries",
                        omission.words(),
                        kind.first.message(NamedSetting.MARKED))));
    return lines;
  }
}
