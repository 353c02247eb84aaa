package org.hificamsim.cli;

import java.util.List;
import org.hificamsim.core.InputException;

/** Lists whose every name has to be there once. */
final class Distinct {
  private Distinct() {}

  /**
   * Checks a list.
   *
   * @param what it is, for the message
   * @throws InputException when a name is there twice
   */
  static void require(String what, List<String> names) {
    for (int i = 0; i < names.size(); i++) {
      if (names.indexOf(names.get(i)) < i) {
        throw new InputException(what + " has '" + names.get(i) + "' twice, expected each once");
      }
    }
  }
}
