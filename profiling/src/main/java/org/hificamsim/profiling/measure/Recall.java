package org.hificamsim.profiling.measure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Recall against the object's height in pixels: of the photos whose object is about as high, the
 * share in which a detector has found it. Photos are sorted by height and cut into ten groups of
 * one size; those of one height stay together.
 */
final class Recall {
  /** What the column's name ends in. */
  static final String SUFFIX = "-recall";

  private static final int GROUPS = 10;

  private Recall() {}

  /**
   * The rows with a column more.
   *
   * @param heights of the objects, pixels, in the order of the rows
   */
  static List<Measurement> with(List<Measurement> rows, int[] heights, String detector) {
    List<Integer> order =
        IntStream.range(0, rows.size())
            .boxed()
            .sorted(Comparator.comparingInt(i -> heights[i]))
            .toList();
    List<Measurement> more = new ArrayList<>(rows);
    int from = 0;
    for (int group = 1; group <= GROUPS; group++) {
      int to = Math.max(from, end(order, heights, group * rows.size() / GROUPS));
      List<Integer> members = order.subList(from, to);
      double recall = found(rows, members, detector);
      members.forEach(i -> more.set(i, rows.get(i).with(detector + SUFFIX, recall)));
      from = to;
    }
    return more;
  }

  /** A group's end, moved on to where the height changes. */
  private static int end(List<Integer> order, int[] heights, int wanted) {
    int end = wanted;
    while (end > 0
        && end < order.size()
        && heights[order.get(end)] == heights[order.get(end - 1)]) {
      end++;
    }
    return end;
  }

  private static double found(List<Measurement> rows, List<Integer> members, String detector) {
    return members.stream().filter(i -> rows.get(i).confidence(detector) > 0).count()
        / (double) Math.max(1, members.size());
  }
}
