package org.hificamsim.tracks.format;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.Fields;

/**
 * Distinguishes the columns of ids and frames in rows that have both, then x and y: from row to row
 * of an id, a target moves less than from one target to another.
 */
final class ColumnOrder {
  private static final int X = 2;
  private static final int Y = 3;

  /** The least factor by which the wrong column lengthens steps. */
  private static final double CLEAR = 3;

  private ColumnOrder() {}

  /**
   * Says whether a column may be that of ids.
   *
   * @param ids the column, 0 or 1; the other one would be that of frames
   */
  static FormatFit fit(FileStart start, int ids) {
    if (Double.isNaN(start.rows().get(0).value(ids))) {
      return FormatFit.no("the first row has no number in column %s".formatted(ids + 1));
    }
    double step = medianStep(start.rows(), ids);
    double otherStep = medianStep(start.rows(), 1 - ids);
    if (Double.isNaN(step) && !Double.isNaN(otherStep)) {
      return FormatFit.no(
          "column %s has each number once, so that it is not an id".formatted(ids + 1));
    }
    if (step > CLEAR * otherStep) {
      return FormatFit.no(
          Texts.format(
              "steps are %.3g times as long if column %s is the id, not column %s",
              step / otherStep, ids + 1, 2 - ids));
    }
    return FormatFit.yes(start.look() + ", the id in column " + (ids + 1));
  }

  /** The median distance between successive rows with the same id; NaN if all ids differ. */
  private static double medianStep(List<LineFields> rows, int ids) {
    Map<String, Fields> last = new HashMap<>();
    List<Double> steps = new ArrayList<>();
    for (Fields row : rows) {
      Fields before = row.count() > Y ? last.put(row.text(ids), row) : null;
      if (before != null) {
        steps.add(Math.hypot(row.value(X) - before.value(X), row.value(Y) - before.value(Y)));
      }
    }
    double[] sorted =
        steps.stream().mapToDouble(Double::doubleValue).filter(Double::isFinite).sorted().toArray();
    return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
  }
}
