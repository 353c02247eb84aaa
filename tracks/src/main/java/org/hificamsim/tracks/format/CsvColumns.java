package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Fields;

/**
 * The columns of a table that a sample needs. The user names them by their names in the first line
 * or by numbers from 1; by default they have the names of the keys. If all are given by number, the
 * first line is data.
 *
 * @param isHeader whether the first line has the names of the columns
 * @param count the number of columns
 * @param tick the column of times or frames, from 0, as all others
 * @param target the column of ids; -1 if the table is about one target
 * @param width the column of widths; -1 if there is none
 * @param height the column of heights; -1 if there is none
 */
record CsvColumns(
    boolean isHeader, int count, int tick, int target, int x, int y, int width, int height) {
  /** The end of a name of times in milliseconds, such as {@code time_ms} or {@code t [ms]}. */
  private static final Pattern MILLISECONDS =
      Pattern.compile("(?i:(.*[^a-z])?(ms|msecs?|millis|milliseconds?)[)\\]]?)|.*[a-z]Ms");

  private static final Set<String> KEYS =
      Set.of("time", "frame", "id", "x", "y", "width", "height");

  /** Finds columns by the user's names of them. */
  private record Names(Recording recording, Fields firstLine, List<String> header) {
    static Names of(Recording recording, Fields firstLine) {
      List<String> header = new ArrayList<>();
      for (int i = 0; i < firstLine.count(); i++) {
        String name = firstLine.text(i);
        header.add(i == 0 ? name.replaceFirst("^#\\s*", "") : name);
      }
      return new Names(recording, firstLine, header);
    }

    boolean areNumbers() {
      return !recording.columns().isEmpty()
          && recording.columns().values().stream().allMatch(Names::isNumber);
    }

    int required(String key) {
      int column = column(key);
      if (column < 0) {
        throw firstLine
            .place(0)
            .error(
                "no column '%s' for %s, expected %s with it, of: %s",
                name(key), key, setting("columns"), String.join(", ", header));
      }
      return column;
    }

    /** The column of a key; -1 if there is none. */
    int column(String key) {
      String name = name(key);
      int column = areNumbers() ? -1 : indexOf(header, name);
      if (column >= 0 && header.lastIndexOf(header.get(column)) != column) {
        throw firstLine
            .place(0)
            .error(
                "two columns have the name '%s', expected one, or their numbers with %s",
                header.get(column), setting("columns"));
      }
      boolean isIndex = column < 0 && isNumber(name) && Integer.parseInt(name) <= header.size();
      return isIndex ? Integer.parseInt(name) - 1 : column;
    }

    String name(String key) {
      return recording.columns().getOrDefault(key, key);
    }

    private static boolean isNumber(String name) {
      return name.matches("[1-9][0-9]{0,3}");
    }
  }

  /**
   * Finds the columns.
   *
   * @param firstLine first line of the table
   * @throws InputException if a required column, or one that the user names, is missing
   */
  static CsvColumns find(Recording recording, Fields firstLine) {
    Names names = Names.of(recording, firstLine);
    boolean namesId = recording.columns().containsKey("id");
    return new CsvColumns(
        !names.areNumbers(),
        firstLine.count(),
        names.required(countsFrames(recording, names.header()) ? "frame" : "time"),
        namesId ? names.required("id") : names.column("id"),
        names.required("x"),
        names.required("y"),
        names.column("width"),
        names.column("height"));
  }

  /**
   * Whether a table counts frames: the user says so, or it has a column of frames and none of
   * times.
   */
  static boolean countsFrames(Recording recording, List<String> header) {
    Set<String> keys = recording.columns().keySet();
    boolean isFrame = indexOf(header, "frame") >= 0 && indexOf(header, "time") < 0;
    return keys.contains("frame") || (isFrame && !keys.contains("time"));
  }

  /** Reads times or frames of this table, whose first line may have their unit. */
  Ticks ticks(Recording recording, Fields firstLine) {
    List<String> names = IntStream.range(0, count).mapToObj(firstLine::text).toList();
    return countsFrames(recording, names)
        ? Ticks.of(recording, tick)
        : Ticks.times(isHeader && MILLISECONDS.matcher(names.get(tick)).matches());
  }

  /**
   * Checks that degrees are not in the wrong order.
   *
   * @throws InputException if the name of the column of x, a longitude, is that of a latitude
   */
  void requireLongitudeFirst(Recording recording, Fields firstLine) {
    String name = firstLine.text(x).toLowerCase(Locale.ROOT);
    if (isHeader && recording.unit().equals(Optional.of(Unit.DEG)) && name.startsWith("lat")) {
      throw firstLine
          .place(x)
          .error("x is the column '%s', expected the longitude, and y the latitude", name);
    }
  }

  /** The first column with a name, in any case if no case matches; -1 if there is none. */
  static int indexOf(List<String> header, String name) {
    int column = header.indexOf(name);
    for (int i = 0; i < header.size() && column < 0; i++) {
      column = header.get(i).equalsIgnoreCase(name) ? i : -1;
    }
    return column;
  }

  /**
   * Checks the keys for which the user names columns.
   *
   * @throws InputException if there is another one
   */
  static void requireValidKeys(Recording recording) {
    for (String key : recording.columns().keySet()) {
      if (!KEYS.contains(key)) {
        throw InputException.of(
            "%s has '%s', expected time or frame, id, x, y, width, height",
            setting("columns"), key);
      }
    }
  }

  /** Whether a row has neither an id nor a position. */
  boolean isEmpty(Fields row) {
    return target >= 0 && isEmpty(row, target) && isEmpty(row, x) && isEmpty(row, y);
  }

  private static boolean isEmpty(Fields row, int column) {
    return column >= row.count() || row.text(column).isBlank();
  }
}
