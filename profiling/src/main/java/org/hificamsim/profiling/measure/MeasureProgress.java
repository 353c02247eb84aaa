package org.hificamsim.profiling.measure;

/** Hears how far a measurement is, by any thread. */
@FunctionalInterface
public interface MeasureProgress {
  /** One photo more has been measured. */
  void measured();

  /** So many photos had been measured before, by an earlier call. */
  default void resumed(int photos) {}
}
