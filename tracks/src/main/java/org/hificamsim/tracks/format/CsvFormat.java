package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * A table of comma, semicolon or tab separated values, of which the user says which column has
 * what: a name in its first line, or a number from 1. Where the user says nothing, the columns have
 * the names that are asked for; where all are known by number, the first line is data.
 */
final class CsvFormat implements TrackFormat {
  private static final Set<String> KNOWN =
      Set.of("time", "frame", "id", "x", "y", "width", "height");

  private Recording recording;
  private boolean byNumber;
  private List<String> header;

  // Columns, from 0.
  private int tick;
  private int target;
  private int x;
  private int y;
  private int width; // -1 where the table has none, as for the height
  private int height;

  @Override
  public Clock read(Recording file, SampleSink samples) {
    recording = file;
    requireKnown();
    boolean frames = recording.columns().containsKey("frame");
    Clock clock = frames ? recording.frames() : Clock.SECONDS;
    samples.measuredIn(recording.requireUnit("a table does not say it"));
    try (CsvReader table = CsvReader.open(recording.file(), "fields between separators")) {
      CsvRow first = table.first();
      find(first.texts(), frames ? "frame" : "time");
      if (byNumber) {
        samples.accept(sample(first));
      }
      table.each(row -> samples.accept(sample(row)));
    }
    return clock;
  }

  private void requireKnown() {
    for (String key : recording.columns().keySet()) {
      if (!KNOWN.contains(key)) {
        throw InputException.of(
            "%s has '%s', expected time or frame, id, x, y, width, height",
            setting("columns"), key);
      }
    }
  }

  private void find(List<String> firstLine, String tickName) {
    header = firstLine;
    byNumber =
        !recording.columns().isEmpty()
            && recording.columns().values().stream().allMatch(CsvFormat::isNumber);
    tick = required(tickName);
    target = required("id");
    x = required("x");
    y = required("y");
    width = column("width");
    height = column("height");
  }

  private int required(String key) {
    int column = column(key);
    if (column < 0) {
      throw new Place(recording.file().toString(), 1, 1)
          .error(
              "no column '%s' for %s, expected %s with it, of: %s",
              name(key), key, setting("columns"), String.join(", ", header));
    }
    return column;
  }

  private int column(String key) {
    String name = name(key);
    int named = byNumber ? -1 : header.indexOf(name);
    boolean numbered = named < 0 && isNumber(name) && Integer.parseInt(name) <= header.size();
    return numbered ? Integer.parseInt(name) - 1 : named;
  }

  private String name(String key) {
    return recording.columns().getOrDefault(key, key);
  }

  private static boolean isNumber(String name) {
    return name.matches("[1-9][0-9]{0,3}");
  }

  private TrackSample sample(CsvRow row) {
    if (row.text(target).isEmpty()) {
      throw row.invalid(target, "id", "a name or number");
    }
    return new TrackSample(
        row.place(0),
        row.text(target),
        row.coordinate(tick, "time"),
        row.coordinate(x, "x"),
        row.coordinate(y, "y"),
        length(row, width, "width"),
        length(row, height, "height"));
  }

  private static double length(CsvRow row, int column, String name) {
    return column < 0
        ? Double.NaN
        : row.number(column, name, "a number above 0", value -> value > 0 && value <= 1e9);
  }
}
