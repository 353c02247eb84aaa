package org.hificamsim.core.scenario;

import org.hificamsim.core.InputException;

/**
 * A place in a file, as error lines name it.
 *
 * @param line from 1
 * @param column from 1, in characters
 */
public record Place(String file, int line, int column) {
  /** An error line for this place. */
  public InputException error(String message) {
    return new InputException(this + ": " + message);
  }

  @Override
  public String toString() {
    return file + ":" + line + ":" + column;
  }
}
