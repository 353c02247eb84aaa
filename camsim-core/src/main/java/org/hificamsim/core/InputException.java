package org.hificamsim.core;

/**
 * A fault in what the user gave (a file, an option, a name), reported in one line: where it is,
 * what is wrong, the value, and what was expected. The command line prints the message alone and
 * exits with 2.
 *
 * <p>A message names a setting by {@link NamedSetting#setting}. {@link #getMessage} has its plain
 * name; a front end prints {@link #message} in the notation that its users know.
 */
public final class InputException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /** Creates a fault with a message of one line, which begins with its place if it has one. */
  public InputException(String message) {
    super(message);
  }

  /** Creates a fault that has another one as its cause. */
  public InputException(String message, Throwable cause) {
    super(message, cause);
  }

  /** Creates a fault whose message has values, in the form of {@link Texts#format}. */
  public static InputException of(String form, Object... values) {
    return new InputException(Texts.format(form, values));
  }

  /** Sets the cause of this fault, and returns the fault. */
  public InputException because(Throwable cause) {
    initCause(cause);
    return this;
  }

  /** The message, with the plain names of settings. */
  @Override
  public String getMessage() {
    return message(NamedSetting.PLAIN);
  }

  /** The message, with the settings that it names as the users of a front end write them. */
  public String message(NamedSetting.Notation notation) {
    return NamedSetting.written(String.valueOf(super.getMessage()), notation);
  }
}
