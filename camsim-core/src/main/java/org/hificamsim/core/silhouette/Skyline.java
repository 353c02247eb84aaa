package org.hificamsim.core.silhouette;

import java.util.Arrays;

/** The upper border of rectangles that stand on the lower side of the unit square. */
final class Skyline {
  /** Where the pieces begin, ascending from 0. */
  private double[] starts = new double[16];

  /** The heights of the pieces, at most 1. */
  private double[] heights = new double[16];

  private double[] otherStarts = new double[16];
  private double[] otherHeights = new double[16];
  private int count;
  private int filled;

  /** Removes all rectangles. */
  void clear() {
    count = 1;
    starts[0] = 0;
    heights[0] = 0;
  }

  /** The number of pieces of one height. */
  int count() {
    return count;
  }

  double start(int piece) {
    return starts[piece];
  }

  double end(int piece) {
    return piece + 1 < count ? starts[piece + 1] : 1;
  }

  double height(int piece) {
    return heights[piece];
  }

  /** Whether the whole square is covered. */
  boolean full() {
    return count == 1 && heights[0] == 1;
  }

  /** Adds a rectangle within the unit square. */
  void add(double from, double to, double height) {
    if (otherStarts.length < count + 2) {
      starts = Arrays.copyOf(starts, 2 * starts.length);
      heights = Arrays.copyOf(heights, 2 * heights.length);
      otherStarts = new double[starts.length];
      otherHeights = new double[starts.length];
    }
    filled = 0;
    for (int piece = 0; piece < count; piece++) {
      double start = starts[piece];
      double end = end(piece);
      if (end <= from || start >= to || heights[piece] >= height) {
        append(start, heights[piece]);
      } else {
        if (start < from) {
          append(start, heights[piece]);
        }
        append(Math.max(start, from), height);
        if (end > to) {
          append(to, heights[piece]);
        }
      }
    }
    swap();
  }

  private void append(double start, double height) {
    if (filled == 0 || otherHeights[filled - 1] != height) {
      otherStarts[filled] = start;
      otherHeights[filled++] = height;
    }
  }

  private void swap() {
    double[] lastStarts = starts;
    double[] lastHeights = heights;
    starts = otherStarts;
    heights = otherHeights;
    otherStarts = lastStarts;
    otherHeights = lastHeights;
    count = filled;
  }

  /** The covered share of the square. */
  double area() {
    double area = 0;
    for (int piece = 0; piece < count; piece++) {
      area += (end(piece) - starts[piece]) * heights[piece];
    }
    return area;
  }
}
