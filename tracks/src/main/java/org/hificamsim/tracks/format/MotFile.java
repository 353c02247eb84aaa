package org.hificamsim.tracks.format;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;

/**
 * Reads MOTChallenge files row by row: {@code frame,id,left,top,width,height[,conf[,x,y,z]]}. Rows
 * of nine columns have a class and a visibility after the confidence (MOT16 and later) and no
 * position in the world.
 */
public final class MotFile {
  static final int FRAME_COLUMN = 0;
  static final int BOX_COLUMNS = 6;
  static final int COLUMNS_WITH_WORLD = 10;
  private static final int COLUMNS_WITH_CLASS = 9;
  private static final int CLASS_COLUMN = 7;

  /** The value in columns that a file does not use. */
  private static final String NONE = "-1";

  private static final int X_COLUMN = 7;

  private final Ticks ticks;
  private int columns; // 0 before the first row

  /**
   * A row of a MOTChallenge file: a target's box in one frame.
   *
   * @param place the row's place in the file
   * @param frame number of the frame, from 1
   * @param target the number of the target
   * @param left the left edge of the box, in pixels
   * @param top the upper edge of the box, pixels down from the picture's upper edge
   * @param width width of the box, in pixels
   * @param height height of the box, in pixels
   * @param confidence 0 if the row is to be ignored; 1 if the file has no confidences
   * @param x position in the world; NaN if the file has none
   * @param y position in the world; NaN if the file has none
   * @param z position in the world; NaN if the file has none
   * @param type the class of the target; empty if the file has none
   * @param visibility the visible share, in [0, 1]; NaN if the file has none
   */
  public record Row(
      Place place,
      double frame,
      String target,
      double left,
      double top,
      double width,
      double height,
      double confidence,
      double x,
      double y,
      double z,
      String type,
      double visibility) {
    /** Whether the row has a position in the world. */
    public boolean isInWorld() {
      return !Double.isNaN(x);
    }

    /** The middle of the box's lower edge, pixels to the right. */
    public double footX() {
      return left + width / 2;
    }

    /** The lower edge of the box, pixels down. */
    public double footY() {
      return top + height;
    }
  }

  private MotFile(Ticks ticks) {
    this.ticks = ticks;
  }

  /**
   * Reads all rows of a file.
   *
   * @throws org.hificamsim.core.InputException with the place, if a row is wrong
   */
  public static void read(Path file, Consumer<Row> rows) {
    Recording frames = Recording.of(file).at(1);
    OddRows refused =
        (kind, reason) -> {
          throw reason.get();
        };
    read(frames, Ticks.of(frames, FRAME_COLUMN), refused, rows);
  }

  /** Reads all rows; wrong ones go to {@code odd}. */
  static void read(Recording recording, Ticks ticks, OddRows odd, Consumer<Row> rows) {
    MotFile file = new MotFile(ticks);
    RowTable.forEachRow(
        recording,
        "rows of frame,id,left,top,width,height",
        fields -> {
          if (!fields.text(0).startsWith("#")) {
            odd.reading(() -> rows.accept(file.row(fields)));
          }
        });
  }

  private Row row(Fields fields) {
    columns = columns == 0 ? Math.max(BOX_COLUMNS, fields.count()) : columns;
    double frame = OddRows.part(Omission.NO_TIME, () -> ticks.tick(fields, FRAME_COLUMN));
    String target = OddRows.part(Omission.NO_TARGET, () -> RowFormat.target(fields, 1));
    return OddRows.part(
        fields.count() == columns ? Omission.NO_PLACE : Omission.OTHER_COLUMNS,
        () -> row(fields, frame, target));
  }

  private Row row(Fields fields, double frame, String target) {
    if (fields.count() != columns && fields.count() >= BOX_COLUMNS) {
      throw fields.invalid(columns, "further field", columns + " fields as in the first line");
    }
    boolean inWorld = columns >= COLUMNS_WITH_WORLD && !isNowhere(fields);
    return new Row(
        fields.place(0),
        frame,
        target,
        fields.coordinate(2, "left"),
        fields.coordinate(3, "top"),
        length(fields, 4, "width"),
        length(fields, 5, "height"),
        columns > BOX_COLUMNS ? fields.number(BOX_COLUMNS, "confidence") : 1,
        inWorld ? fields.coordinate(X_COLUMN, "x") : Double.NaN,
        inWorld ? fields.coordinate(X_COLUMN + 1, "y") : Double.NaN,
        inWorld ? fields.coordinate(X_COLUMN + 2, "z") : Double.NaN,
        hasClasses() && !fields.text(CLASS_COLUMN).equals(NONE) ? fields.text(CLASS_COLUMN) : "",
        hasClasses() ? share(fields.value(CLASS_COLUMN + 1)) : Double.NaN);
  }

  /** Whether a row has no position in the world: x and y are both -1. */
  private static boolean isNowhere(Fields fields) {
    return fields.number(X_COLUMN, "x") == -1 && fields.number(X_COLUMN + 1, "y") == -1;
  }

  private boolean hasClasses() {
    return columns == COLUMNS_WITH_CLASS;
  }

  private static double share(double value) {
    return value >= 0 && value <= 1 ? value : Double.NaN;
  }

  private static double length(Fields fields, int field, String name) {
    return fields.number(
        field, name, "a number of pixels from 0", value -> value >= 0 && value <= 1e9);
  }
}
