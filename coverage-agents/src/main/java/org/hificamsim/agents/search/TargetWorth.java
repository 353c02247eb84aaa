package org.hificamsim.agents.search;

/**
 * What a target adds to a sum by the number k of cameras that cover it: a table that never falls,
 * and is flat from {@link #top} on.
 */
final class TargetWorth {
  /** Of what counts as 1: all numbers to 16 divide it, so that slopes are whole numbers. */
  private static final long UNIT = 720_720;

  private static final double MAX_SUM = 0x1p62;

  private final long[] values;
  private final long unit;
  private final boolean concave;
  private int top;

  /**
   * @param worths by k, as {@link org.hificamsim.core.metrics.Objective#worths} gives them
   * @param most how many such worths are added up at most
   */
  TargetWorth(long[] worths, double most) {
    unit = worths[worths.length - 1] * UNIT * most < MAX_SUM ? UNIT : 1;
    values = new long[worths.length];
    for (int k = 0; k < values.length; k++) {
      values[k] = worths[k] * unit;
    }
    boolean falling = true;
    for (int k = 2; k < values.length; k++) {
      falling &= values[k] - values[k - 1] <= values[k - 1] - values[k - 2];
    }
    concave = falling;
    cut(values.length - 1);
  }

  /** Lets no camera after the k-th count. */
  void cut(int k) {
    top = k;
    while (top > 0 && values[top] == values[top - 1]) {
      top--;
    }
  }

  /** What counts as 1; all sums are multiples of it. */
  long unit() {
    return unit;
  }

  /** The number of cameras from which on a further one is worth nothing. */
  int top() {
    return top;
  }

  /** The worth of a target that k cameras cover. */
  long of(int k) {
    return values[Math.min(k, top)];
  }

  /** What the camera after the k-th adds. */
  long gain(int k) {
    return k < top ? values[k + 1] - values[k] : 0;
  }

  /** The number of cameras, up to {@code supply}, that a target buys at a price: the fewest. */
  int bought(int supply, long price) {
    int bought = 0;
    for (int k = 1; k <= supply && k <= top; k++) {
      bought = values[k] - price * k > values[bought] - price * bought ? k : bought;
    }
    return bought;
  }

  /**
   * The most that a target's worth exceeds its price, bought from {@code least} to {@code most}.
   */
  long profit(int least, int most, long price) {
    long profit = of(least) - price * least;
    for (int k = least + 1; k <= most && k <= top; k++) {
      profit = Math.max(profit, values[k] - price * k);
    }
    return profit;
  }

  /**
   * The least price at which no number of cameras from k up to {@code supply} is worth more than it
   * costs, rounded up; 0 where nothing can be gained.
   */
  long slope(int k, int supply) {
    long slope = supply > k ? gain(k) : 0;
    for (int more = 2; !concave && k + more <= Math.min(supply, top); more++) {
      slope = Math.max(slope, -Math.floorDiv(values[k] - values[k + more], more));
    }
    return slope;
  }
}
