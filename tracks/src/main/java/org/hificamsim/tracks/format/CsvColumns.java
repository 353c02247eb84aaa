package org.hificamsim.tracks.format;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * Which column of a table has what: a name in its first line, or a number from 1. Without a word
 * from the user the columns have the names that are asked for.
 */
final class CsvColumns {
  private static final Set<String> KNOWN =
      Set.of("time", "frame", "id", "x", "y", "width", "height");

  /**
   * The columns from 0; -1 where the table has none.
   *
   * @param tick of seconds or frames
   */
  record Found(int tick, int target, int x, int y, int width, int height) {}

  private final Map<String, String> names;

  private CsvColumns(Map<String, String> names) {
    this.names = names;
  }

  /**
   * What the user says.
   *
   * @throws InputException when it is about something that is not asked for
   */
  static CsvColumns of(Recording recording) {
    recording.columns().keySet().stream()
        .filter(key -> !KNOWN.contains(key))
        .findFirst()
        .ifPresent(
            key -> {
              throw new InputException(
                  "--columns has '%s', expected time or frame, id, x, y, width, height"
                      .formatted(key));
            });
    return new CsvColumns(recording.columns());
  }

  /** Whether time is counted in frames. */
  boolean ofFrames() {
    return names.containsKey("frame");
  }

  /** Whether all columns are known by number, so that the first line is data. */
  boolean byNumber() {
    return !names.isEmpty() && names.values().stream().allMatch(CsvColumns::isNumber);
  }

  /**
   * The columns of a table.
   *
   * @param header its first line
   * @throws InputException when one that is needed is not there
   */
  Found in(Recording recording, List<String> header) {
    return new Found(
        required(recording, header, ofFrames() ? "frame" : "time"),
        required(recording, header, "id"),
        required(recording, header, "x"),
        required(recording, header, "y"),
        find(header, "width"),
        find(header, "height"));
  }

  private int required(Recording recording, List<String> header, String key) {
    int found = find(header, key);
    if (found < 0) {
      throw new Place(recording.file().toString(), 1, 1)
          .error(
              "no column '%s' for %s, expected --columns with it, of: %s"
                  .formatted(names.getOrDefault(key, key), key, String.join(", ", header)));
    }
    return found;
  }

  private int find(List<String> header, String key) {
    String name = names.getOrDefault(key, key);
    int found = byNumber() ? -1 : header.indexOf(name);
    if (found < 0 && isNumber(name) && Integer.parseInt(name) <= header.size()) {
      return Integer.parseInt(name) - 1;
    }
    return found;
  }

  private static boolean isNumber(String name) {
    return name.matches("[1-9][0-9]{0,3}");
  }
}
