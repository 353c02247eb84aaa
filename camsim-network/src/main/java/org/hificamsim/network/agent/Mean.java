package org.hificamsim.network.agent;

/** A mean of what is added until it is taken, for the zoom bandit (behaviour 9.6). */
public final class Mean {
  private double sum;
  private long count;

  /** Adds a value, 1 or 0. */
  void add(boolean value) {
    add(value ? 1 : 0, 1);
  }

  /** Adds {@code number} values by their sum. */
  public void add(double values, int number) {
    sum += values;
    count += number;
  }

  /** Whether anything was added since it was taken last. */
  public boolean isKnown() {
    return count > 0;
  }

  /** The mean of what was added since it was taken last; 0 of nothing. */
  public double take() {
    double mean = count == 0 ? 0 : sum / count;
    sum = 0;
    count = 0;
    return mean;
  }
}
