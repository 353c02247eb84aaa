package org.hificamsim.hifi.json;

import org.hificamsim.core.InputException;

/**
 * A place in a file, as error lines give it.
 *
 * @param file the file as the user named it
 * @param line line from 1
 * @param column column from 1, in bytes
 */
public record Place(String file, int line, int column) {
  /** The fault {@code FILE:LINE:COLUMN: problem}, in one line whatever the texts hold. */
  public InputException fault(String problem) {
    String message = file + ":" + line + ":" + column + ": " + problem;
    return new InputException(message.replaceAll("\\p{Cntrl}+", " "));
  }
}
