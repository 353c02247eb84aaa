package org.hificamsim.hifi.json;

import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/**
 * A place in a file, as error lines give it.
 *
 * @param file the file as the user named it
 * @param line line from 1
 * @param column column from 1, in bytes
 */
public record Place(String file, int line, int column) {
  private static final Pattern UNPRINTABLE =
      Pattern.compile("[\\p{Cntrl}\\x{80}-\\x{9f}\\x{2028}\\x{2029}]+");
  private static final int LONGEST_PROBLEM = 500;

  /** The fault {@code FILE:LINE:COLUMN: problem}, in one short line whatever the texts hold. */
  public InputException fault(String problem) {
    String message =
        file
            + ":"
            + line
            + ":"
            + column
            + ": "
            + (problem.length() <= LONGEST_PROBLEM
                ? problem
                : problem.substring(0, LONGEST_PROBLEM) + "...");
    return new InputException(UNPRINTABLE.matcher(message).replaceAll(" "));
  }
}
