package org.hificamsim.tracks.format;

/** The reasons for which a row or point of a recording is not a sample and is left out. */
public enum Omission {
  /** The row has no valid time. */
  NO_TIME("without a time", true),
  /** The row does not name its target. */
  NO_TARGET("without an id", true),
  /** The row has no position, or one that is not a number. */
  NO_PLACE("without a place", true),
  /** The row has other columns than the rows before. */
  OTHER_COLUMNS("with another number of columns", true),
  /** The format marks the position as one to be predicted. */
  UNKNOWN_PLACE("whose place is unknown", false),
  /** The id and position are empty, because the row is about something else. */
  OTHER_THING("with neither id nor place", false),
  /** The format marks the row as unused: confidence 0, lost, or a predicted alternative. */
  MARKED("that the file marks as not to be used", false),
  /** The point is a waypoint, or part of a route or shape, not a position of a target. */
  NO_TRACK("of no track", false);

  private final String words;
  private final boolean fault;

  Omission(String words, boolean fault) {
    this.words = words;
    this.fault = fault;
  }

  /** The kind in words that follow "entries". */
  public String words() {
    return words;
  }

  /** Whether many omissions of this kind show that the file is read in the wrong way. */
  public boolean isFault() {
    return fault;
  }
}
