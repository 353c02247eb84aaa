package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Finds MOT files whose last three columns are not positions: in VisDrone and UAVDT they are a
 * class, a truncation and an occlusion.
 */
final class MotFlags {
  private static final int MAX_CLASS = 20;
  private static final int MAX_FLAG = 2;

  private long rows;
  private boolean areFlags = true;
  private OptionalDouble firstLeft = OptionalDouble.empty();
  private boolean boxesMove;

  /** Adds a row whose last columns are read as a position. */
  void add(MotFile.Row row) {
    rows++;
    areFlags &=
        isWhole(row.x(), MAX_CLASS) && isWhole(row.y(), MAX_FLAG) && isWhole(row.z(), MAX_FLAG);
    boxesMove |= firstLeft.isPresent() && firstLeft.getAsDouble() != row.left();
    firstLeft = firstLeft.isPresent() ? firstLeft : OptionalDouble.of(row.left());
  }

  private static boolean isWhole(double value, int most) {
    return value == Math.rint(value) && value >= 0 && value <= most;
  }

  /** The sign of a wrong reading; empty if the columns may be positions. */
  Optional<Doubt> sign() {
    return rows > 1 && areFlags && boxesMove
        ? Optional.of(
            new Doubt(
                ("columns 8 to 10 are small whole numbers in all %s rows: a class and flags, and no"
                        + " places in metres")
                    .formatted(rows),
                setting("unit", "px") + " and " + setting("homography", "FILE")))
        : Optional.empty();
  }
}
