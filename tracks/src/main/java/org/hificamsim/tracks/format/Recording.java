package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * A file of tracks with the settings that its user gives.
 *
 * @param rate frames per second; may be empty
 * @param unit unit of positions; may be empty
 * @param columns the names or numbers of columns by key, for formats without a fixed order
 */
public record Recording(
    Path file, OptionalDouble rate, Optional<Unit> unit, Map<String, String> columns) {
  /** Copies the map. */
  public Recording {
    columns = Map.copyOf(columns);
  }

  /** A recording without any settings. */
  public static Recording of(Path file) {
    return new Recording(file, OptionalDouble.empty(), Optional.empty(), Map.of());
  }

  /** Returns this recording with another rate. */
  public Recording at(double newRate) {
    return new Recording(file, OptionalDouble.of(newRate), unit, columns);
  }

  /**
   * Returns the beginning of the file.
   *
   * @throws InputException if it is missing or cannot be read
   */
  FileStart start() {
    return FileStart.of(file);
  }

  /**
   * Returns the clock of a format that counts frames.
   *
   * @throws InputException if the rate is not given
   */
  public Clock frames() {
    return new Clock(
        rate.orElseThrow(
            () ->
                missing(
                    setting("rate", "R")
                        + ", the frames per second, which a file of this format does not have")),
        false);
  }

  /**
   * Returns the unit.
   *
   * @param reason why it has to be given
   * @throws InputException if it is not given
   */
  public Unit requireUnit(String reason) {
    return unit.orElseThrow(
        () -> missing(setting("unit") + ", one of " + Spelling.all(Unit.class) + ": " + reason));
  }

  /**
   * Returns the unit of a format that has only one.
   *
   * @throws InputException if the user gives another unit
   */
  public Unit only(Unit formatUnit) {
    if (unit.isPresent() && unit.get() != formatUnit) {
      throw InputException.of(
          "%s: %s is %s, expected %s or none, because the format has no other",
          file, setting("unit"), Spelling.of(unit.get()), Spelling.of(formatUnit));
    }
    return formatUnit;
  }

  /** Returns the error of a setting that is required for the file. */
  public InputException missing(String expected) {
    return new InputException(file + ": expected " + expected);
  }
}
