package org.hificamsim.tracks.format;

/** Why a row of a recording, or a point, is not a sample and is left out. */
public enum Omission {
  /** It has no time, or one that is not a time. */
  NO_TIME("without a time", true),
  /** It does not say which target it is about. */
  NO_TARGET("without an id", true),
  /** It has no position, or one that is not a number. */
  NO_PLACE("without a place", true),
  /** It has other columns than the rows before. */
  OTHER_COLUMNS("with another number of columns", true),
  /** Its position is to be predicted: the format says so. */
  UNKNOWN_PLACE("whose place is unknown", false),
  /** Its id and place are empty: it is about something else than the named columns. */
  OTHER_THING("with neither id nor place", false),
  /** The format marks it as not to be used: confidence 0, lost, a predicted alternative. */
  MARKED("that the file marks as not to be used", false),
  /** It is a waypoint, a route or a shape, which no target moves along. */
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

  /** Whether a file with many of them is probably read in the wrong way. */
  public boolean isFault() {
    return fault;
  }
}
