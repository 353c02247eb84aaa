package org.hificamsim.presentation.view;

/** No command is done any more: the session was closed, or an error, the cause, has broken it. */
final class SessionEnded extends RuntimeException {
  private static final long serialVersionUID = 1L;

  SessionEnded() {
    super("the session has ended");
  }

  SessionEnded(Error cause) {
    super(
        "the session has ended: %s: %s"
            .formatted(cause.getClass().getSimpleName(), cause.getMessage()),
        cause);
  }
}
