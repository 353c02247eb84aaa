package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * A file of tracks with what its user says of it.
 *
 * @param rate frames a second, where given
 * @param unit of positions, where given
 * @param columns which column has what, for formats without a fixed order
 */
public record Recording(
    Path file, OptionalDouble rate, Optional<Unit> unit, Map<String, String> columns) {
  /** Copies what could change. */
  public Recording {
    columns = Map.copyOf(columns);
  }

  /**
   * The clock of a format that counts frames.
   *
   * @throws InputException when nobody has said how many there are in a second
   */
  public Clock frames() {
    return new Clock(
        rate.orElseThrow(
            () ->
                missing(
                    setting("rate", "R")
                        + ", the frames a second by which this format counts: it does not say")),
        false);
  }

  /**
   * The unit.
   *
   * @throws InputException when nobody has said it
   */
  public Unit requireUnit(String why) {
    return unit.orElseThrow(
        () -> missing(setting("unit") + ", one of " + Spelling.all(Unit.class) + ": " + why));
  }

  /** The unit of a format that says its own; another one is refused. */
  public Unit only(Unit own) {
    if (unit.isPresent() && unit.get() != own) {
      throw InputException.of(
          "%s: %s is %s, expected %s or none: the format says so",
          file, setting("unit"), Spelling.of(unit.get()), Spelling.of(own));
    }
    return own;
  }

  /** What a user has to say before the file can be read. */
  public InputException missing(String option) {
    return new InputException(file + ": expected " + option);
  }
}
