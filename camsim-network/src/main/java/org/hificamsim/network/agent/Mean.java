package org.hificamsim.network.agent;

/** A mean, 0 of nothing, which begins anew when it has been taken. */
public final class Mean {
  private double sum;
  private int count;

  /** Adds this many values with this sum. */
  public void add(double values, int number) {
    sum += values;
    count += number;
  }

  /** Whether nothing was added since it was taken last. */
  public boolean isEmpty() {
    return count == 0;
  }

  /** The mean of what was added since it was taken last. */
  public double take() {
    double mean = isEmpty() ? 0 : sum / count;
    sum = 0;
    count = 0;
    return mean;
  }
}
