package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Rows that are left out together in a validation: those of one object, of one lens, or of a fold.
 *
 * @param unit what one group is, such as {@code object}
 * @param rows the rows of each group; every row is in one
 */
public record Groups(String unit, List<int[]> rows) {
  /** One group for each object. */
  public static Groups byObject(List<Measurement> rows) {
    return by("object", rows, Measurement::object);
  }

  /** One group for each focal length. */
  public static Groups byLens(List<Measurement> rows) {
    return by("lens", rows, Measurement::focalLength);
  }

  /**
   * Folds of equal size.
   *
   * @param seed of the shuffle that deals the rows to the folds
   */
  public static Groups folds(int size, int k, long seed) {
    int[] order = shuffled(size, seed);
    return new Groups(
        "fold",
        IntStream.range(0, k)
            .mapToObj(
                fold ->
                    IntStream.range(0, size)
                        .filter(i -> i % k == fold)
                        .map(i -> order[i])
                        .toArray())
            .toList());
  }

  /** How many groups there are; a validation needs two or more. */
  public int count() {
    return rows.size();
  }

  /** How many rows there are. */
  public int size() {
    return rows.stream().mapToInt(group -> group.length).sum();
  }

  /** The rows that are not in a group, in order. */
  public int[] others(int group) {
    boolean[] left = new boolean[size()];
    for (int row : rows.get(group)) {
      left[row] = true;
    }
    return IntStream.range(0, left.length).filter(i -> !left[i]).toArray();
  }

  /** Some things without those of each group; none where leaving a group out leaves nothing. */
  <T> List<List<T>> withoutEach(List<T> all) {
    return IntStream.range(0, count() > 1 ? count() : 0)
        .mapToObj(group -> at(others(group), all))
        .toList();
  }

  /** A value of a row, and of the group that it is in. */
  interface RowValue {
    double of(int group, int row);
  }

  /** A value for each row. */
  double[] each(RowValue value) {
    double[] all = new double[size()];
    for (int group = 0; group < count(); group++) {
      for (int row : rows.get(group)) {
        all[row] = value.of(group, row);
      }
    }
    return all;
  }

  /** How well each group is predicted. */
  List<FitScores> scores(double[] observed, double[] predicted) {
    return rows.stream().map(of -> FitScores.of(at(of, observed), at(of, predicted))).toList();
  }

  /** Some elements of an array. */
  static double[] at(int[] rows, double[] values) {
    return IntStream.of(rows).mapToDouble(row -> values[row]).toArray();
  }

  /** Some elements of a list. */
  static <T> List<T> at(int[] rows, List<T> values) {
    return IntStream.of(rows).mapToObj(values::get).toList();
  }

  private static Groups by(String unit, List<Measurement> rows, Function<Measurement, ?> key) {
    Map<Object, List<Integer>> groups = new LinkedHashMap<>();
    for (int i = 0; i < rows.size(); i++) {
      groups.computeIfAbsent(key.apply(rows.get(i)), any -> new ArrayList<>()).add(i);
    }
    return new Groups(
        unit,
        groups.values().stream()
            .map(group -> group.stream().mapToInt(Integer::intValue).toArray())
            .toList());
  }

  private static int[] shuffled(int size, long seed) {
    int[] order = IntStream.range(0, size).toArray();
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = size - 1; i > 0; i--) {
      int j = random.nextInt(i + 1);
      int swapped = order[i];
      order[i] = order[j];
      order[j] = swapped;
    }
    return order;
  }
}
