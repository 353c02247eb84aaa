package org.hificamsim.core.silhouette;

import java.util.Arrays;

/**
 * The upper border of shapes that stand on the lower side of the unit square, in pieces of straight
 * lines.
 */
final class Skyline {
  private static final int START = 0;
  private static final int INTERCEPT = 1;
  private static final int SLOPE = 2;
  private static final int VALUES = 3;

  /** The start of each piece, ascending from 0, and its intercept, at most 1. */
  private double[] pieces = new double[16 * VALUES];

  private double[] otherPieces = new double[16 * VALUES];
  private int count;
  private int filled;

  /** Removes all shapes. */
  void clear() {
    count = 1;
    pieces[START] = 0;
    pieces[INTERCEPT] = 0;
    pieces[SLOPE] = 0;
  }

  /** The number of pieces. */
  int count() {
    return count;
  }

  double start(int piece) {
    return pieces[piece * VALUES + START];
  }

  double end(int piece) {
    return piece + 1 < count ? start(piece + 1) : 1;
  }

  /** The height of the piece's line at x = 0. */
  double intercept(int piece) {
    return pieces[piece * VALUES + INTERCEPT];
  }

  double slope(int piece) {
    return pieces[piece * VALUES + SLOPE];
  }

  /** Whether the whole square is covered. */
  boolean full() {
    return count == 1 && pieces[INTERCEPT] == 1 && pieces[SLOPE] == 0;
  }

  /**
   * Adds a shape within the unit square under a straight line.
   *
   * @param intercept the line's height at x = 0
   */
  void add(double from, double to, double intercept, double slope) {
    int first = firstLower(from, to, intercept, slope);
    if (first < count) {
      raise(first, from, to, intercept, slope);
    }
  }

  /** The first piece that is lower somewhere between two positions; the count if there is none. */
  private int firstLower(double from, double to, double intercept, double slope) {
    for (int piece = 0; piece < count && start(piece) < to; piece++) {
      if (isLower(piece, from, to, intercept, slope)) {
        return piece;
      }
    }
    return count;
  }

  private boolean isLower(int piece, double from, double to, double intercept, double slope) {
    double left = Math.max(start(piece), from);
    double right = Math.min(end(piece), to);
    return left < right
        && (above(piece, intercept, slope, left) > 0 || above(piece, intercept, slope, right) > 0);
  }

  private double above(int piece, double intercept, double slope, double x) {
    return intercept - intercept(piece) + (slope - slope(piece)) * x;
  }

  private void raise(int first, double from, double to, double intercept, double slope) {
    if (otherPieces.length < 3 * (count + 1) * VALUES) {
      pieces = Arrays.copyOf(pieces, 2 * otherPieces.length);
      otherPieces = new double[pieces.length];
    }
    System.arraycopy(pieces, 0, otherPieces, 0, first * VALUES);
    filled = first;
    for (int piece = first; piece < count; piece++) {
      if (isLower(piece, from, to, intercept, slope)) {
        raisePiece(piece, from, to, intercept, slope);
      } else {
        append(start(piece), intercept(piece), slope(piece));
      }
    }
    swap();
  }

  private void raisePiece(int piece, double from, double to, double intercept, double slope) {
    double left = Math.max(start(piece), from);
    double right = Math.min(end(piece), to);
    if (start(piece) < from) {
      append(start(piece), intercept(piece), slope(piece));
    }
    double atLeft = above(piece, intercept, slope, left);
    double atRight = above(piece, intercept, slope, right);
    double meeting = left + (right - left) * (atLeft / (atLeft - atRight));
    if (atLeft < 0) {
      append(left, intercept(piece), slope(piece));
      append(meeting, intercept, slope);
    } else {
      append(left, intercept, slope);
    }
    if (atRight < 0) {
      append(meeting, intercept(piece), slope(piece));
    } else if (end(piece) > to) {
      append(to, intercept(piece), slope(piece));
    }
  }

  private void append(double start, double intercept, double slope) {
    int last = (filled - 1) * VALUES;
    if (filled == 0
        || otherPieces[last + INTERCEPT] != intercept
        || otherPieces[last + SLOPE] != slope) {
      otherPieces[filled * VALUES + START] = start;
      otherPieces[filled * VALUES + INTERCEPT] = intercept;
      otherPieces[filled * VALUES + SLOPE] = slope;
      filled++;
    }
  }

  private void swap() {
    double[] last = pieces;
    pieces = otherPieces;
    otherPieces = last;
    count = filled;
  }

  /** The covered share of the square. */
  double area() {
    double area = 0;
    for (int piece = 0; piece < count; piece++) {
      double start = start(piece);
      double end = end(piece);
      area += (end - start) * (intercept(piece) + slope(piece) * ((start + end) / 2));
    }
    return area;
  }
}
