package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.tracks.format.Doubt;

/**
 * Puts the rows of targets that are not in the order of time in this order. If time goes back
 * because another recording begins, sorting by time mixes both, and targets jump back and forth.
 */
final class RowOrder {
  /**
   * The factor by which ways may become longer in the order of time; beyond it, there are several
   * recordings.
   */
  private static final double MAX_RATIO = 2;

  private final boolean reusesIds;
  private long rows;
  private int targets;
  private int reusedIds;
  private Place firstLateRow; // null without late rows
  private double lengthAsInFile;
  private double lengthInTime;

  /**
   * @param reusesIds whether a target of the same name may be another one where time goes back
   */
  RowOrder(boolean reusesIds) {
    this.reusesIds = reusesIds;
  }

  /**
   * Returns targets with their samples in the order of time.
   *
   * @throws org.hificamsim.core.InputException if one is at two places at the same time
   */
  List<RecordedTarget> sort(Collection<RecordedTarget> recorded) {
    List<RecordedTarget> sorted = new ArrayList<>();
    for (RecordedTarget target : recorded) {
      if (reusesIds && !target.lateRows().isEmpty() && target.isAtTwoPlaces()) {
        reusedIds++;
        sorted.addAll(target.runs());
      } else {
        sort(target);
        sorted.add(target);
      }
    }
    return sorted;
  }

  private void sort(RecordedTarget target) {
    if (!target.lateRows().isEmpty()) {
      rows += target.lateRows().size();
      targets++;
      firstLateRow = firstLateRow == null ? target.lateRows().get(0).place() : firstLateRow;
      lengthAsInFile += target.length();
      target.sort();
      lengthInTime += target.length();
    }
  }

  /** The lines on how rows were sorted. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    if (rows > 0) {
      lines.add(
          "sorted by time: %s %s of %s targets, the first at %s"
              .formatted(rows, rows == 1 ? "row" : "rows", targets, firstLateRow));
    }
    if (reusedIds > 0) {
      lines.add(
          "ids: %s are used again where time goes back, each time by another target"
              .formatted(reusedIds));
    }
    return lines;
  }

  /** The sign that a file has several recordings; empty if there is none. */
  Optional<Doubt> sign() {
    return lengthInTime > MAX_RATIO * lengthAsInFile
        ? Optional.of(
            new Doubt(
                Texts.format(
                    "time goes back at %s, and in the order of time targets move %.3g m, not"
                        + " %.3g m: another recording probably begins there",
                    firstLateRow, lengthInTime, lengthAsInFile),
                "a file for each recording, or other ids by " + setting("columns", "id=...")))
        : Optional.empty();
  }
}
