package org.hificamsim.tracks.format;

import java.util.function.Supplier;
import org.hificamsim.core.InputException;

/** Receives the rows that are not samples. */
@FunctionalInterface
public interface OddRows {
  /**
   * Receives a row that is left out.
   *
   * @param reason returns the error, with its place in the file
   */
  void leaveOut(Omission kind, Supplier<InputException> reason);

  /** Reads a row, or leaves it out if one of its {@link #part parts} is wrong. */
  default void reading(Runnable row) {
    try {
      row.run();
    } catch (OddRow odd) {
      leaveOut(odd.kind, () -> odd.reason);
    }
  }

  /** Reads a part of a row; if the part is faulty, the row is left out. */
  static <T> T part(Omission kind, Supplier<T> reading) {
    try {
      return reading.get();
    } catch (InputException fault) {
      throw new OddRow(kind, fault);
    }
  }

  /** Ends the {@link #reading} of a row that is left out. */
  final class OddRow extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final Omission kind;
    private final transient InputException reason;

    OddRow(Omission kind, InputException reason) {
      super(null, reason, false, false);
      this.kind = kind;
      this.reason = reason;
    }
  }
}
