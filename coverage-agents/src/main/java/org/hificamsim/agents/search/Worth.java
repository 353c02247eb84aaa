package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * What a target adds to the value of a choice, by the number k of cameras that cover it: a table
 * that never falls, and is flat from {@link #top} on.
 */
final class Worth {
  /** Of what counts as 1: all numbers to 16 divide it. */
  static final long UNIT = 720_720;

  private final long[] values;
  private int top;
  private long step;
  private boolean concave;

  /** Worth nothing, with room for so many cameras. */
  Worth(int maxCameras) {
    values = new long[maxCameras + 2];
  }

  /** A target is worth {@link #UNIT} once {@code enough} cameras cover it. */
  void whereCovered(int enough) {
    begin(Math.min(enough, values.length - 1), UNIT);
    values[top] = UNIT;
    concave = enough == 1;
  }

  /** Each camera up to {@code cap} is worth {@link #UNIT}. */
  void ofEachUpTo(int cap) {
    begin(Math.min(cap, values.length - 1), UNIT);
    for (int k = 0; k <= top; k++) {
      values[k] = k * UNIT;
    }
  }

  /**
   * One target more that is covered {@code j} times outweighs whatever happens to those above j,
   * for j from {@code from} + 1 to {@code from + levels}.
   *
   * @param base one more than there are targets
   */
  void falling(int from, int levels, long base) {
    begin(from + levels, 1);
    long weight = 1;
    for (int k = top; k > from; k--) {
      values[k] = weight;
      weight *= base;
    }
    for (int k = 1; k <= top; k++) {
      values[k] += values[k - 1];
    }
    concave = from == 0;
  }

  private void begin(int newTop, long newStep) {
    top = newTop;
    step = newStep;
    concave = true;
    Arrays.fill(values, 0, top + 1, 0);
  }

  /** The worth of a target that k cameras cover. */
  long of(int k) {
    return values[Math.min(k, top)];
  }

  /** The most that a target's worth exceeds what it pays for up to {@code supply} cameras more. */
  long surplus(int k, int supply, long price) {
    long most = of(k);
    for (int y = 1; y <= supply && k + y <= top; y++) {
      most = Math.max(most, values[k + y] - price * y);
    }
    return most;
  }

  /** For how many cameras that is, from none on. */
  int bought(int supply, long price) {
    int bought = 0;
    for (int y = 1; y <= supply && y <= top; y++) {
      bought = values[y] - price * y > values[bought] - price * bought ? y : bought;
    }
    return bought;
  }

  /** From so many cameras on a further one is worth nothing. */
  int top() {
    return top;
  }

  /** All sums are multiples of it. */
  long step() {
    return step;
  }

  /**
   * The least price for which y cameras more are never worth more than y prices, for y up to {@code
   * supply}, rounded up; 0 where nothing more can be had.
   */
  long slope(int k, int supply) {
    int most = Math.min(supply, top - k);
    if (most <= 0) {
      return 0;
    }
    long slope = values[k + 1] - values[k];
    for (int y = 2; y <= most && !concave; y++) {
      slope = Math.max(slope, -Math.floorDiv(values[k] - values[k + y], y));
    }
    return slope;
  }
}
