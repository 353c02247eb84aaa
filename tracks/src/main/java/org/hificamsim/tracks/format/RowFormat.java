package org.hificamsim.tracks.format;

import java.util.List;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/**
 * ETH/UCY: rows of numbers separated by spaces or tabs, in metres and frames. A position {@code ?}
 * is one that is to be predicted.
 */
final class RowFormat implements TrackFormat {
  static final KnownFormat OBSMAT =
      new KnownFormat(
          "obsmat",
          "ETH/UCY: `frame id x z y vx vz vy`",
          "frames: `{rate}`",
          "m; the third position is the second axis on the ground",
          () -> new RowFormat("frame id x z y vx vz vy"));

  static final KnownFormat ETHUCY =
      new KnownFormat(
          "ethucy",
          "ETH/UCY as text: `frame id x y`",
          "frames: `{rate}`",
          "m; `?` is unknown",
          () -> new RowFormat("frame id x y"));

  private static final String UNKNOWN = "?";

  private final List<String> columns;
  private final int frame;
  private final int id;
  private final int x;
  private final int y;

  /**
   * @param columns the columns that a row must have, in order and separated by spaces: {@code
   *     frame}, {@code id}, {@code x}, {@code y} and others
   */
  RowFormat(String columns) {
    this.columns = List.of(columns.split(" "));
    frame = this.columns.indexOf("frame");
    id = this.columns.indexOf("id");
    x = this.columns.indexOf("x");
    y = this.columns.indexOf("y");
  }

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    FormatFit shape = RowShape.blanks("ETH/UCY", columns.size(), columns.size()).fit(start);
    if (!shape.fits() || columns.size() > 4) {
      return shape.fits() && !start.hasNumbers()
          ? FormatFit.no("the first row is not of numbers")
          : shape;
    }
    return PeTrackFormat.hasHeader(start)
        ? FormatFit.no("a comment says that the first column is the id")
        : ColumnOrder.fit(start, 1);
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Ticks ticks = Ticks.of(recording, frame);
    samples.measuredIn(recording.only(Unit.M));
    try (TextLines lines = TextLines.open(recording.file())) {
      while (lines.nextFields()) {
        samples.reading(() -> samples.accept(sample(lines, ticks)));
      }
    }
    return ticks.clock();
  }

  /** Returns the sample of a row, which must have all columns. */
  TrackSample sample(Fields fields, Ticks ticks) {
    if (fields.count() >= columns.size()) {
      double number = fields.value(id);
      TrackSample sample =
          new TrackSample(
              fields.place(0),
              name(number),
              ticks.value(fields, frame),
              fields.value(x),
              fields.value(y));
      if (Double.isFinite(number) && sample.isValid()) {
        return sample;
      }
    }
    return oddSample(fields, ticks);
  }

  /** Reads a row part by part, to find the one that is wrong. */
  private TrackSample oddSample(Fields fields, Ticks ticks) {
    String target = OddRows.part(Omission.NO_TARGET, () -> target(fields, id));
    double tick = OddRows.part(Omission.NO_TIME, () -> ticks.tick(fields, frame));
    Omission noPlace =
        isUnknown(fields, x) && isUnknown(fields, y) ? Omission.UNKNOWN_PLACE : Omission.NO_PLACE;
    TrackSample sample =
        new TrackSample(
            fields.place(0),
            target,
            tick,
            OddRows.part(noPlace, () -> fields.coordinate(x, "x")),
            OddRows.part(noPlace, () -> fields.coordinate(y, "y")));
    OddRows.part(Omission.OTHER_COLUMNS, () -> requireAllColumns(fields));
    return sample;
  }

  private static boolean isUnknown(Fields fields, int column) {
    return column < fields.count() && fields.text(column).equals(UNKNOWN);
  }

  private int requireAllColumns(Fields fields) {
    if (fields.count() < columns.size()) {
      throw fields.invalid(fields.count(), "further number", columns.size() + " columns");
    }
    return columns.size();
  }

  /** Returns the name of a target that the file has as a number; 1.000000e+00 becomes 1. */
  static String target(Fields fields, int field) {
    return name(fields.number(field, "id"));
  }

  private static String name(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }
}
