package org.hificamsim.tracks.format;

import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;
import org.hificamsim.data.CsvReader;

/**
 * Reads MOTChallenge files row by row: {@code frame,id,left,top,width,height[,conf[,x,y,z]]}. Rows
 * of nine columns have a class and a visibility behind the confidence (MOT16 and later) and no
 * position in the world.
 */
public final class MotFile {
  private static final int BOX = 6; // columns
  private static final int WORLD = 7; // the column of x
  private static final int WITH_WORLD = 10; // columns

  /**
   * A row of a MOTChallenge file: a target's box in one frame.
   *
   * @param place in the file
   * @param frame from 1
   * @param target its number
   * @param left of the box, pixels
   * @param top of the box, pixels from the picture's upper edge down
   * @param width pixels
   * @param height pixels
   * @param confidence 0 where the row is not to count; 1 where the file has none
   * @param x in the world, NaN where the file does not say
   * @param y in the world, NaN where the file does not say
   * @param z in the world, NaN where the file does not say
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
      double z) {
    /** Whether the file says where on the ground the target was. */
    public boolean inWorld() {
      return !Double.isNaN(x);
    }

    /** Where the box stands, to the right, pixels. */
    public double footX() {
      return left + width / 2;
    }

    /** Where the box stands, down, pixels. */
    public double footY() {
      return top + height;
    }
  }

  private MotFile() {}

  /**
   * Reads them all.
   *
   * @throws org.hificamsim.core.InputException with the place, when something is wrong
   */
  public static void read(Path file, Consumer<Row> rows) {
    try (CsvReader table =
        CsvReader.betweenCommas(file, "rows of frame,id,left,top,width,height")) {
      int[] columns = {0}; // of the first row
      table.each(
          row -> {
            if (!row.text(0).startsWith("#")) {
              columns[0] = columns[0] == 0 ? Math.max(BOX, row.count()) : columns[0];
              rows.accept(row(row, columns[0]));
            }
          });
    }
  }

  private static Row row(Fields fields, int columns) {
    if (fields.count() != columns && fields.count() >= BOX) {
      throw fields.invalid(columns, "further field", columns + " fields as in the first line");
    }
    boolean inWorld = columns >= WITH_WORLD && !isNowhere(fields);
    return new Row(
        fields.place(0),
        fields.number(0, "frame"),
        RowFormat.target(fields, 1),
        fields.coordinate(2, "left"),
        fields.coordinate(3, "top"),
        length(fields, 4, "width"),
        length(fields, 5, "height"),
        columns > BOX ? fields.number(BOX, "confidence") : 1,
        inWorld ? fields.coordinate(WORLD, "x") : Double.NaN,
        inWorld ? fields.coordinate(WORLD + 1, "y") : Double.NaN,
        inWorld ? fields.coordinate(WORLD + 2, "z") : Double.NaN);
  }

  /** x and y are both -1 where there is none. */
  private static boolean isNowhere(Fields fields) {
    return fields.number(WORLD, "x") == -1 && fields.number(WORLD + 1, "y") == -1;
  }

  private static double length(Fields fields, int field, String name) {
    return fields.number(
        field, name, "a number of pixels from 0", value -> value >= 0 && value <= 1e9);
  }
}
