package org.hificamsim.solver.configuration;

/**
 * The worth that a target adds to a sum, by the number k of cameras that cover it: a table that
 * never falls and is constant from {@link #saturation} on.
 */
final class TargetWorth {
  /**
   * A unit that is divisible by all numbers up to 16, so that slopes over up to 16 cameras are
   * whole numbers.
   */
  private static final long DIVISIBLE_UNIT = 720_720;

  private static final double MAX_SUM = 0x1p62;

  private final long[] values;
  private final long unit;
  private final boolean concave;
  private int saturation;

  /**
   * @param worths the worth of each k, as {@link org.hificamsim.core.metrics.Objective#worths}
   *     gives them
   * @param maxTerms the number of such worths that are added up at most
   */
  TargetWorth(long[] worths, double maxTerms) {
    boolean fits = worths[worths.length - 1] * DIVISIBLE_UNIT * maxTerms < MAX_SUM;
    unit = fits ? DIVISIBLE_UNIT : 1;
    values = new long[worths.length];
    for (int k = 0; k < values.length; k++) {
      values[k] = worths[k] * unit;
    }
    boolean gainsNeverRise = true;
    for (int k = 2; k < values.length; k++) {
      gainsNeverRise &= values[k] - values[k - 1] <= values[k - 1] - values[k - 2];
    }
    concave = gainsNeverRise;
    cut(values.length - 1);
  }

  /** Makes cameras beyond the k-th worth nothing, in place of an earlier cut. */
  void cut(int k) {
    saturation = k;
    while (saturation > 0 && values[saturation] == values[saturation - 1]) {
      saturation--;
    }
  }

  /** The amount that the objective counts as 1; all sums are multiples of it. */
  long unit() {
    return unit;
  }

  /** The least number of cameras after which a further one is worth nothing. */
  int saturation() {
    return saturation;
  }

  /** The worth of a target that k cameras cover. */
  long value(int k) {
    return values[Math.min(k, saturation)];
  }

  /** The worth that a further camera adds when k cameras cover the target. */
  long gain(int k) {
    return k < saturation ? values[k + 1] - values[k] : 0;
  }

  /**
   * The number of cameras that a target buys at a price for each, up to {@code max}: the one with
   * the greatest profit, of equal ones the fewest.
   */
  int demand(int max, long price) {
    int demand = 0;
    for (int k = 1; k <= max && k <= saturation; k++) {
      demand = values[k] - price * k > values[demand] - price * demand ? k : demand;
    }
    return demand;
  }

  /** The greatest profit, worth less price, of a target that buys {@code min} to {@code max}. */
  long profit(int min, int max, long price) {
    long profit = value(min) - price * min;
    for (int k = min + 1; k <= max && k <= saturation; k++) {
      profit = Math.max(profit, values[k] - price * k);
    }
    return profit;
  }

  /**
   * The least price, rounded up, at which no number of cameras beyond {@code k}, up to {@code max},
   * is worth more than it costs; 0 if nothing can be gained.
   */
  long slope(int k, int max) {
    long slope = max > k ? gain(k) : 0;
    for (int more = 2; !concave && k + more <= Math.min(max, saturation); more++) {
      slope = Math.max(slope, -Math.floorDiv(values[k] - values[k + more], more));
    }
    return slope;
  }
}
