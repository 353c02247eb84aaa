package org.hificamsim.core;

/**
 * A fault in what the user gave (a file, an option, a name), told in one line: where it is, what is
 * wrong, the value, and what was expected. The command line prints the message alone and exits with
 * 2.
 */
public final class InputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public InputException(String message) {
    super(message);
  }

  public InputException(String message, Throwable cause) {
    super(message, cause);
  }
}
