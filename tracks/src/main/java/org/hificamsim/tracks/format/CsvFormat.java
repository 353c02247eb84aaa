package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * A table of values separated by commas, semicolons or tabs. The user names the columns, by their
 * names in the first line or by numbers from 1; by default they have the names of {@code KEYS}. If
 * all are given by number, the first line is data.
 */
final class CsvFormat implements TrackFormat {
  private static final Set<String> KEYS =
      Set.of("time", "frame", "id", "x", "y", "width", "height");

  private Recording recording;
  private boolean byNumber;
  private List<String> header;

  // Indices of columns, from 0; -1 for a width or height that the table does not have.
  private int tickColumn;
  private int targetColumn;
  private int xColumn;
  private int yColumn;
  private int widthColumn;
  private int heightColumn;

  @Override
  public Clock read(Recording file, SampleSink samples) {
    recording = file;
    requireValidKeys();
    boolean countsFrames = recording.columns().containsKey("frame");
    Clock clock = countsFrames ? recording.frames() : Clock.SECONDS;
    samples.measuredIn(recording.requireUnit("a table does not have it"));
    try (CsvReader table = CsvReader.open(recording.file(), "fields between separators")) {
      CsvRow first = table.first();
      findColumns(first.texts(), countsFrames ? "frame" : "time");
      if (byNumber) {
        samples.accept(sample(first));
      }
      table.forEachRow(row -> samples.accept(sample(row)));
    }
    return clock;
  }

  private void requireValidKeys() {
    for (String key : recording.columns().keySet()) {
      if (!KEYS.contains(key)) {
        throw InputException.of(
            "%s has '%s', expected time or frame, id, x, y, width, height",
            setting("columns"), key);
      }
    }
  }

  private void findColumns(List<String> firstLine, String tickName) {
    header = firstLine;
    byNumber =
        !recording.columns().isEmpty()
            && recording.columns().values().stream().allMatch(CsvFormat::isNumber);
    tickColumn = required(tickName);
    targetColumn = required("id");
    xColumn = required("x");
    yColumn = required("y");
    widthColumn = column("width");
    heightColumn = column("height");
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
    int column = byNumber ? -1 : header.indexOf(name);
    boolean isIndex = column < 0 && isNumber(name) && Integer.parseInt(name) <= header.size();
    return isIndex ? Integer.parseInt(name) - 1 : column;
  }

  private String name(String key) {
    return recording.columns().getOrDefault(key, key);
  }

  private static boolean isNumber(String name) {
    return name.matches("[1-9][0-9]{0,3}");
  }

  private TrackSample sample(CsvRow row) {
    if (row.text(targetColumn).isEmpty()) {
      throw row.invalid(targetColumn, "id", "a name or number");
    }
    return new TrackSample(
        row.place(0),
        row.text(targetColumn),
        row.coordinate(tickColumn, "time"),
        row.coordinate(xColumn, "x"),
        row.coordinate(yColumn, "y"),
        length(row, widthColumn, "width"),
        length(row, heightColumn, "height"));
  }

  private static double length(CsvRow row, int column, String name) {
    return column < 0
        ? Double.NaN
        : row.number(column, name, "a number above 0", value -> value > 0 && value <= 1e9);
  }
}
