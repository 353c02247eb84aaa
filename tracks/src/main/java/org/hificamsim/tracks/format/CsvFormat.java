package org.hificamsim.tracks.format;

import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * A table of comma, semicolon or tab separated values with a line of names, of which the user says
 * which column has what.
 */
final class CsvFormat implements TrackFormat {
  @Override
  public Clock read(Recording recording, SampleSink samples) {
    CsvColumns columns = CsvColumns.of(recording);
    Clock clock = columns.ofFrames() ? recording.frames() : Clock.SECONDS;
    samples.measuredIn(recording.requireUnit("a table does not say it"));
    try (CsvReader table = CsvReader.open(recording.file(), "fields between separators")) {
      CsvRow first = table.first();
      CsvColumns.Found found = columns.in(recording, first.texts());
      if (columns.byNumber()) {
        samples.accept(sample(first, found));
      }
      table.each(row -> samples.accept(sample(row, found)));
    }
    return clock;
  }

  private static Sample sample(CsvRow row, CsvColumns.Found found) {
    return new Sample(
        row.place(0),
        target(row, found.target()),
        row.coordinate(found.tick(), "time"),
        row.coordinate(found.x(), "x"),
        row.coordinate(found.y(), "y"),
        length(row, found.width(), "width"),
        length(row, found.height(), "height"));
  }

  private static String target(CsvRow row, int column) {
    if (row.text(column).isEmpty()) {
      throw row.invalid(column, "id", "a name or number");
    }
    return row.text(column);
  }

  /** NaN where the table has no such column. */
  private static double length(CsvRow row, int column, String name) {
    return column < 0
        ? Double.NaN
        : row.number(column, name, "a number above 0", value -> value > 0 && value <= 1e9);
  }
}
