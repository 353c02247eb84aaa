package org.hificamsim.profiling.boxes;

import blogspot.software_and_algorithms.stern_library.optimization.HungarianAlgorithm;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The labelled people of a frame that a detector found. Detections are assigned to people so that
 * there are as many pairs as possible and, among these assignments, the sum of overlaps is greatest
 * (Hungarian algorithm).
 *
 * @param found for each label whether it was found; false for those that do not count
 * @param falseAlarms the number of detections that overlap with no label
 */
record FrameMatch(boolean[] found, int falseAlarms) {
  /** The cost of a pair that overlaps too little; pairs that are allowed cost 1 or less. */
  private static final double NO_PAIR = 3;

  /**
   * Matches a frame.
   *
   * @param leastOverlap the least intersection over union of a pair, above 0
   */
  static FrameMatch of(FrameBoxes frame, double leastOverlap) {
    List<LabelledBox> labels = frame.labels();
    boolean[] found = new boolean[labels.size()];
    BitSet free = new BitSet();
    free.set(0, frame.detections().size());
    for (boolean counted : new boolean[] {true, false}) {
      int[] candidates =
          IntStream.range(0, found.length)
              .filter(label -> labels.get(label).counted() == counted)
              .toArray();
      match(frame, candidates, free, leastOverlap, found);
    }
    for (int label = 0; label < found.length; label++) {
      found[label] &= labels.get(label).counted();
    }
    return new FrameMatch(found, free.cardinality());
  }

  /** Matches some labels with the detections that are free, which then no longer are. */
  private static void match(
      FrameBoxes frame, int[] labels, BitSet free, double leastOverlap, boolean[] found) {
    int[] detections = free.stream().toArray();
    if (labels.length == 0 || detections.length == 0) {
      return;
    }
    double[][] costs = new double[labels.length][detections.length];
    for (int i = 0; i < labels.length; i++) {
      Box label = frame.labels().get(labels[i]).box();
      Arrays.setAll(
          costs[i], k -> cost(label.overlap(frame.detections().get(detections[k])), leastOverlap));
    }
    int[] assigned = new HungarianAlgorithm(costs).execute();
    for (int i = 0; i < labels.length; i++) {
      if (assigned[i] >= 0 && costs[i][assigned[i]] < NO_PAIR) {
        found[labels[i]] = true;
        free.clear(detections[assigned[i]]);
      }
    }
  }

  private static double cost(double overlap, double leastOverlap) {
    return overlap >= leastOverlap ? 1 - overlap : NO_PAIR;
  }
}
