package org.hificamsim.tracks.format;

/**
 * Whether the beginning of a file looks like a format, and why.
 *
 * @param fits whether the file is recognised
 * @param isReadable whether the format can be right although the file is not recognised
 * @param reason words that follow "the file", or a clause about the file if it does not fit
 */
record FormatFit(boolean fits, boolean isReadable, String reason) {
  static FormatFit yes(String reason) {
    return new FormatFit(true, true, reason);
  }

  static FormatFit no(String reason) {
    return new FormatFit(false, false, reason);
  }

  /** A fit that leaves the format possible, because users may say what the file contains. */
  static FormatFit named(boolean fits, String reason, String otherwise) {
    return new FormatFit(fits, true, fits ? reason : otherwise);
  }

  /** A fit if a condition holds. */
  static FormatFit of(boolean fits, String reason, String otherwise) {
    return fits ? yes(reason) : no(otherwise);
  }
}
