package org.hificamsim.tracks.format;

import java.util.List;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/** ETH/UCY: rows of numbers between blanks or tabs, metres and frames. */
final class RowFormat implements TrackFormat {
  private final List<String> columns;

  /**
   * @param columns what a row has at least, in order: {@code frame}, {@code id}, {@code x}, {@code
   *     y} and others, between blanks
   */
  RowFormat(String columns) {
    this.columns = List.of(columns.split(" "));
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Clock clock = recording.frames();
    samples.measuredIn(recording.only(Unit.M));
    try (TextLines lines = TextLines.open(recording.file())) {
      while (lines.nextFields()) {
        samples.accept(sample(lines));
      }
    }
    return clock;
  }

  /** The sample of a row, all of whose columns must be there. */
  Sample sample(Fields fields) {
    Sample sample =
        new Sample(
            fields.place(0),
            target(fields, columns.indexOf("id")),
            fields.number(columns.indexOf("frame"), "frame"),
            fields.coordinate(columns.indexOf("x"), "x"),
            fields.coordinate(columns.indexOf("y"), "y"));
    if (fields.count() < columns.size()) {
      throw fields.invalid(fields.count(), "further number", columns.size() + " columns");
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
