package org.hificamsim.network.agent;

/** A mean that restarts each time it is taken; 0 if no value was added. */
public final class Mean {
  private double sum;
  private int count;

  /** Adds values by their sum and number. */
  public void add(double sumOfValues, int number) {
    sum += sumOfValues;
    count += number;
  }

  /** Returns whether no value was added since the mean was last taken. */
  public boolean isEmpty() {
    return count == 0;
  }

  /** Returns the mean of the values added since the last call, and restarts it. */
  public double take() {
    double mean = isEmpty() ? 0 : sum / count;
    sum = 0;
    count = 0;
    return mean;
  }
}
