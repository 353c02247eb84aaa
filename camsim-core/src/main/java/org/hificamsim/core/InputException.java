package org.hificamsim.core;

/**
 * A fault in what the user gave (a file, an option, a name), reported in one line: where it is,
 * what is wrong, the value, and what was expected. The command line prints the message alone and
 * exits with 2.
 */
public final class InputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** A fault that the message describes in one line, its place in front where there is one. */
  public InputException(String message) {
    super(message);
  }

  /** A fault that has another one behind it. */
  public InputException(String message, Throwable cause) {
    super(message, cause);
  }

  /** A fault whose message has values, in the form of {@link Texts#format}. */
  public static InputException of(String form, Object... values) {
    return new InputException(Texts.format(form, values));
  }

  /** The same fault with another one behind it. */
  public InputException because(Throwable cause) {
    initCause(cause);
    return this;
  }
}
