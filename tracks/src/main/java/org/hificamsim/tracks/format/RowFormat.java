package org.hificamsim.tracks.format;

import java.util.List;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/** ETH/UCY: rows of numbers separated by spaces or tabs, in metres and frames. */
final class RowFormat implements TrackFormat {
  private final List<String> columns;

  /**
   * @param columns the columns that a row must have, in order and separated by spaces: {@code
   *     frame}, {@code id}, {@code x}, {@code y} and others
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

  /** Returns the sample of a row, which must have all columns. */
  TrackSample sample(Fields fields) {
    TrackSample sample =
        new TrackSample(
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

  /** Returns the name of a target that the file has as a number; 1.000000e+00 becomes 1. */
  static String target(Fields fields, int field) {
    double number = fields.number(field, "id");
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }
}
