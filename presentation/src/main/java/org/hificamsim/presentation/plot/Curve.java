package org.hificamsim.presentation.plot;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Points in the order of x.
 *
 * @param x rising
 * @param y as many as x
 */
public record Curve(double[] x, double[] y) {
  /** Values at x = 0, 1, 2, ... */
  public static Curve of(double[] values) {
    double[] x = new double[values.length];
    Arrays.setAll(x, i -> i);
    return new Curve(x, values);
  }

  /** A point for each of some things. */
  public static <T> Curve of(List<T> all, ToDoubleFunction<T> x, ToDoubleFunction<T> y) {
    return new Curve(all.stream().mapToDouble(x).toArray(), all.stream().mapToDouble(y).toArray());
  }

  /** The number of points. */
  public int size() {
    return x.length;
  }

  /**
   * The means of groups of neighbours, as equal in size as can be.
   *
   * @param most number of groups, 1 or more; with no more points than that, nothing changes
   */
  public Curve thinned(int most) {
    if (size() <= most) {
      return this;
    }
    double[] newX = new double[most];
    double[] newY = new double[most];
    for (int group = 0; group < most; group++) {
      int from = (int) ((long) group * size() / most);
      int to = (int) ((long) (group + 1) * size() / most);
      newX[group] = StatUtils.mean(x, from, to - from);
      newY[group] = StatUtils.mean(y, from, to - from);
    }
    return new Curve(newX, newY);
  }
}
