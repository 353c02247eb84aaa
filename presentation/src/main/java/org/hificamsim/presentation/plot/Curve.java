package org.hificamsim.presentation.plot;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Points of a curve, in the order of x.
 *
 * @param x for each point, its x, ascending
 * @param y for each point, its y
 */
public record Curve(double[] x, double[] y) {
  /** Returns a curve that has these values at x = 0, 1, 2, ... */
  public static Curve of(double[] values) {
    double[] x = new double[values.length];
    Arrays.setAll(x, i -> i);
    return new Curve(x, values);
  }

  /** Returns a curve with a point for each element; the elements must be in the order of x. */
  public static <T> Curve of(List<T> elements, ToDoubleFunction<T> x, ToDoubleFunction<T> y) {
    return new Curve(
        elements.stream().mapToDouble(x).toArray(), elements.stream().mapToDouble(y).toArray());
  }

  /** The number of points. */
  public int size() {
    return x.length;
  }

  /**
   * Returns a curve of fewer points: the means of groups of neighbours, of nearly equal size.
   *
   * @param groups the number of groups, 1 or more; a curve of at most this many points is returned
   *     unchanged
   */
  public Curve thinned(int groups) {
    if (size() <= groups) {
      return this;
    }
    double[] newX = new double[groups];
    double[] newY = new double[groups];
    for (int group = 0; group < groups; group++) {
      int from = (int) ((long) group * size() / groups);
      int to = (int) ((long) (group + 1) * size() / groups);
      newX[group] = StatUtils.mean(x, from, to - from);
      newY[group] = StatUtils.mean(y, from, to - from);
    }
    return new Curve(newX, newY);
  }
}
