package org.hificamsim.tracks.format;

import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/** ETH/UCY: rows of numbers between blanks or tabs, metres and frames. */
final class RowFormat implements TrackFormat {
  private final Row row;

  RowFormat(Row row) {
    this.row = row;
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Clock clock = recording.frames();
    samples.measuredIn(recording.only(Unit.M));
    try (TextLines lines = TextLines.open(recording.file())) {
      while (lines.nextFields()) {
        samples.accept(sample(lines, row));
      }
    }
    return clock;
  }

  /** The sample of a row, all of whose columns must be there. */
  static Sample sample(Fields fields, Row row) {
    Sample sample =
        new Sample(
            fields.place(0),
            target(fields, row.target()),
            fields.number(row.frame(), "frame"),
            fields.coordinate(row.x(), "x"),
            fields.coordinate(row.y(), "y"));
    if (fields.count() < row.columns()) {
      throw fields.invalid(fields.count(), "further number", row.columns() + " columns");
    }
    return sample;
  }

  /** The name of a target that is known by a number: 1.000000e+00 is 1. */
  static String target(Fields fields, int field) {
    double number = fields.number(field, "id");
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }
}
