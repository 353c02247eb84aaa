package org.hificamsim.core.engine;

/**
 * The energy of a run so far.
 *
 * @param joules the joules of all cameras; NaN if nothing is measured
 * @param firstEmpty the number of steps until the first battery was empty; NaN if none is
 * @param halfEmpty the number of steps until half the batteries were empty; NaN before that
 * @param coveredUntilFirst the share of targets covered until then, by any camera; NaN before that
 * @param coveredUntilHalf the same until half the batteries were empty
 */
public record EnergySums(
    double joules,
    double firstEmpty,
    double halfEmpty,
    double coveredUntilFirst,
    double coveredUntilHalf) {
  /** The sums of a run without an energy model. */
  public static final EnergySums NONE =
      new EnergySums(Double.NaN, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
}
