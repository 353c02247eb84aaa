package org.hificamsim.core.silhouette;

import java.util.Arrays;

/**
 * The share of the unit square that shapes cover together: the exact area of their union. A shape
 * is an upright strip whose lower and upper border are straight lines. Most shapes begin below the
 * square, such as nearer people and walls; their union is a {@link Skyline}.
 *
 * <p>Reuse one for many squares: it keeps its arrays. Not thread-safe.
 */
public final class CoveredShare {
  private static final int LEFT = 0;
  private static final int RIGHT = 1;
  private static final int LOW = 2;
  private static final int LOW_SLOPE = 3;
  private static final int HIGH = 4;
  private static final int HIGH_SLOPE = 5;
  private static final int VALUES = 6;

  /**
   * The values of each shape, {@value #VALUES} for each; lines by their height at x = 0 and slope.
   */
  private double[] shapes = new double[16 * VALUES];

  private final Skyline standing = new Skyline();

  /** The positions at which a border of a shape begins, ends, or meets another border. */
  private double[] cuts = new double[64];

  private int count;
  private boolean sloped;

  /** Creates a share without shapes. */
  public CoveredShare() {
    standing.clear();
  }

  /** Removes all shapes. */
  public void clear() {
    count = 0;
    sloped = false;
    standing.clear();
  }

  /** Whether the shapes that begin below the square cover all of it. */
  public boolean full() {
    return standing.full();
  }

  /** Adds a rectangle; what lies outside the unit square does not count. */
  public void add(double left, double low, double right, double high) {
    add(left, right, low, 0, high, 0);
  }

  /**
   * Adds a strip between two lines that do not cross in it.
   *
   * @param low the height of the lower line at x = 0
   * @param high the height of the upper line at x = 0
   */
  public void add(
      double left, double right, double low, double lowSlope, double high, double highSlope) {
    double from = Math.max(0, left);
    double to = Math.min(1, right);
    if (!(from < to) || isOutside(from, to, low, lowSlope, high, highSlope)) {
      return;
    }
    if (Math.max(low + lowSlope * from, low + lowSlope * to) <= 0) {
      stand(from, to, high, highSlope);
    } else {
      keep(from, to, low, lowSlope, high, highSlope);
    }
  }

  /** Adds a strip that begins below the square, in parts above, in and below the square. */
  private void stand(double from, double to, double high, double slope) {
    if (Math.min(high + slope * from, high + slope * to) >= 1) {
      standing.add(from, to, 1, 0);
    } else if (slope == 0) {
      standing.add(from, to, high, 0);
    } else {
      double ground = Math.max(from, Math.min(to, -high / slope));
      double top = Math.max(from, Math.min(to, (1 - high) / slope));
      standing.add(Math.min(ground, top), Math.max(ground, top), high, slope);
      standing.add(slope > 0 ? top : from, slope > 0 ? to : top, 1, 0);
    }
  }

  private void keep(
      double from, double to, double low, double lowSlope, double high, double highSlope) {
    if (count * VALUES == shapes.length) {
      shapes = Arrays.copyOf(shapes, 2 * shapes.length);
    }
    int at = insertionPoint(low);
    System.arraycopy(shapes, at, shapes, at + VALUES, count * VALUES - at);
    shapes[at + LEFT] = from;
    shapes[at + RIGHT] = to;
    shapes[at + LOW] = low;
    shapes[at + LOW_SLOPE] = lowSlope;
    shapes[at + HIGH] = high;
    shapes[at + HIGH_SLOPE] = highSlope;
    count++;
    sloped |= lowSlope != 0 || highSlope != 0;
  }

  private static boolean isOutside(
      double from, double to, double low, double lowSlope, double high, double highSlope) {
    double least = Math.min(low + lowSlope * from, low + lowSlope * to);
    double greatest = Math.max(high + highSlope * from, high + highSlope * to);
    return !(least < 1) || !(greatest > 0);
  }

  /**
   * Returns where a shape belongs in the order of lower lines, in which rectangles need no sorting.
   */
  private int insertionPoint(double low) {
    int at = count * VALUES;
    while (at > 0 && shapes[at - VALUES + LOW] > low) {
      at -= VALUES;
    }
    return at;
  }

  /** Returns the covered share, in [0, 1]. */
  public double share() {
    if (full() || count == 0) {
      return Math.min(1, standing.area());
    }
    for (int piece = 0; piece < standing.count(); piece++) {
      if (standing.intercept(piece) != 0 || standing.slope(piece) != 0) {
        double end = standing.end(piece);
        keep(standing.start(piece), end, 0, 0, standing.intercept(piece), standing.slope(piece));
      }
    }
    return union();
  }

  private double union() {
    int ends = cut();
    Arrays.sort(cuts, 0, ends);
    double area = 0;
    for (int i = 1; i < ends; i++) {
      double width = cuts[i] - cuts[i - 1];
      area += width > 0 ? width * covered((cuts[i] + cuts[i - 1]) / 2) : 0;
    }
    return Math.min(1, area);
  }

  private int cut() {
    int ends = 0;
    for (int at = 0; at < count * VALUES; at += VALUES) {
      ends = cut(ends, shapes[at + LEFT]);
      ends = cut(ends, shapes[at + RIGHT]);
    }
    return sloped ? cutWhereLinesMeet(ends) : ends;
  }

  private int cut(int ends, double x) {
    if (ends == cuts.length) {
      cuts = Arrays.copyOf(cuts, 2 * cuts.length);
    }
    cuts[ends] = x;
    return x >= 0 && x <= 1 ? ends + 1 : ends;
  }

  /** Adds cuts so that between two of them no line meets another one or a side of the square. */
  private int cutWhereLinesMeet(int first) {
    int ends = first;
    for (int i = 0; i < 2 * count; i++) {
      ends = meet(ends, i, 0, 0);
      ends = meet(ends, i, 1, 0);
      for (int k = 0; k < i; k++) {
        ends = meet(ends, i, line(k), slope(k));
      }
    }
    return ends;
  }

  private int meet(int ends, int i, double height, double slope) {
    return slope(i) == slope ? ends : cut(ends, (height - line(i)) / (slope(i) - slope));
  }

  /** The height at x = 0 of a lower line (even) or an upper line (odd). */
  private double line(int i) {
    return shapes[i / 2 * VALUES + (i % 2 == 0 ? LOW : HIGH)];
  }

  private double slope(int i) {
    return shapes[i / 2 * VALUES + (i % 2 == 0 ? LOW_SLOPE : HIGH_SLOPE)];
  }

  /** The length of the upright line at x that is covered. */
  private double covered(double x) {
    if (sloped) {
      sortAt(x);
    }
    double length = 0;
    double end = 0;
    for (int at = 0; at < count * VALUES && end < 1; at += VALUES) {
      if (shapes[at + LEFT] < x && x < shapes[at + RIGHT]) {
        double low = Math.max(end, shapes[at + LOW] + x * shapes[at + LOW_SLOPE]);
        double high = Math.min(1, shapes[at + HIGH] + x * shapes[at + HIGH_SLOPE]);
        length += Math.max(0, high - low);
        end = Math.max(end, high);
      }
    }
    return length;
  }

  /** Sorts the shapes by their lower lines at x. */
  private void sortAt(double x) {
    for (int i = VALUES; i < count * VALUES; i += VALUES) {
      for (int at = i; at > 0 && lowAt(at, x) < lowAt(at - VALUES, x); at -= VALUES) {
        swap(at, at - VALUES);
      }
    }
  }

  private double lowAt(int at, double x) {
    return shapes[at + LOW] + x * shapes[at + LOW_SLOPE];
  }

  private void swap(int at, int other) {
    for (int i = 0; i < VALUES; i++) {
      double value = shapes[at + i];
      shapes[at + i] = shapes[other + i];
      shapes[other + i] = value;
    }
  }
}
