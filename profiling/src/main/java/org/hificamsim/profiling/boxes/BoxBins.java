package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Texts;

/** The ranges of height and hidden share that tables and pictures have. */
final class BoxBins {
  /** The greatest hidden share of a box that counts as not hidden. */
  static final double NOT_HIDDEN = 0.05;

  private static final double[] HIDDEN = {-1, NOT_HIDDEN, 0.25, 0.5, 0.75, 2};
  private static final double[] HEIGHTS = {1, 1.3, 1.6, 2, 2.5, 3.2, 4, 5, 6.5, 8};

  private BoxBins() {}

  /**
   * A range of values.
   *
   * @param from the lower end, exclusive
   * @param to the upper end, inclusive
   * @param label the text for readers
   */
  record Bin(double from, double to, String label) {
    boolean contains(double value) {
      return value > from && value <= to;
    }

    double middle() {
      return (Math.max(0, from) + Math.min(1, to)) / 2;
    }
  }

  /** Returns the ranges of the hidden share. */
  static List<Bin> hidden() {
    List<Bin> bins = new ArrayList<>();
    for (int i = 1; i < HIDDEN.length; i++) {
      String label =
          i == 1
              ? "not hidden"
              : Texts.format(
                  "%.0f to %.0f %% hidden", 100 * HIDDEN[i - 1], 100 * Math.min(1, HIDDEN[i]));
      bins.add(new Bin(HIDDEN[i - 1], HIDDEN[i], label));
    }
    return bins;
  }

  /** Returns the ranges of the height in pixels that contain a box at least. */
  static List<Bin> heights(List<PersonBox> boxes) {
    List<Bin> bins = new ArrayList<>();
    double from = 0;
    for (double power = 1; power < 1e6; power *= 10) {
      for (double factor : HEIGHTS) {
        double to = factor * power;
        Bin bin = new Bin(from, to, Texts.format("%.0f to %.0f px", from, to));
        if (boxes.stream().anyMatch(box -> bin.contains(box.height()))) {
          bins.add(bin);
        }
        from = to;
      }
    }
    return bins;
  }
}
