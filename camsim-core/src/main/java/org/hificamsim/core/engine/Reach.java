package org.hificamsim.core.engine;

/** Distances that squared distances were compared with, rounded up. */
final class Reach {
  /** Far more than what rounding adds, far less than what costs time. */
  private static final double MARGIN = 1 + 1e-9;

  /** Lest squares that are too small for a double count as 0. */
  private static final double LEAST = 1e-150;

  private Reach() {}

  /**
   * A distance that both coordinates of a target keep within, where its squared distance, as
   * computed, is at most this.
   *
   * @param squared square metres; below 0 where there is no such target
   */
  static double ofSquared(double squared) {
    return squared < 0 ? 0 : of(Math.sqrt(squared));
  }

  /** The same where the root of the squared distance is at most this many metres. */
  static double of(double distance) {
    return distance * MARGIN + LEAST;
  }
}
