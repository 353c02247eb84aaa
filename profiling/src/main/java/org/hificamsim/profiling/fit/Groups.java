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
 * The groups of rows that a cross-validation leaves out: one for each object, lens or fold.
 *
 * @param unit the name of a group, such as {@code object}
 * @param rows the rows of each group; every row is in exactly one
 */
public record Groups(String unit, List<int[]> rows) {
  /** Returns one group for each object. */
  public static Groups byObject(List<Measurement> rows) {
    return by("object", rows, Measurement::object);
  }

  /** Returns one group for each focal length. */
  public static Groups byLens(List<Measurement> rows) {
    return by("lens", rows, Measurement::focalLength);
  }

  /**
   * Returns random folds of equal size.
   *
   * @param seed the seed of the assignment of rows to folds
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

  /** Returns the number of groups; a cross-validation needs at least two. */
  public int count() {
    return rows.size();
  }

  /** Returns the number of rows. */
  public int size() {
    return rows.stream().mapToInt(group -> group.length).sum();
  }

  /** Returns the rows that are not in a group, in order. */
  public int[] others(int group) {
    boolean[] inGroup = new boolean[size()];
    for (int row : rows.get(group)) {
      inGroup[row] = true;
    }
    return IntStream.range(0, inGroup.length).filter(row -> !inGroup[row]).toArray();
  }

  /** Returns for each group the items outside it; empty if there is only one group. */
  <T> List<List<T>> withoutEach(List<T> items) {
    return IntStream.range(0, count() > 1 ? count() : 0)
        .mapToObj(group -> select(others(group), items))
        .toList();
  }

  /** Computes a value for a row and the group that it is in. */
  interface RowValue {
    double compute(int group, int row);
  }

  /** Returns a value for each row. */
  double[] forEachRow(RowValue value) {
    double[] values = new double[size()];
    for (int group = 0; group < count(); group++) {
      for (int row : rows.get(group)) {
        values[row] = value.compute(group, row);
      }
    }
    return values;
  }

  /** Returns the scores of the predictions in each group. */
  List<FitScores> scores(double[] observed, double[] predicted) {
    return rows.stream()
        .map(group -> FitScores.of(select(group, observed), select(group, predicted)))
        .toList();
  }

  /** Returns the elements of an array at some rows. */
  static double[] select(int[] rows, double[] values) {
    return IntStream.of(rows).mapToDouble(row -> values[row]).toArray();
  }

  /** Returns the elements of a list at some rows. */
  static <T> List<T> select(int[] rows, List<T> values) {
    return IntStream.of(rows).mapToObj(values::get).toList();
  }

  private static Groups by(String unit, List<Measurement> rows, Function<Measurement, ?> key) {
    Map<Object, List<Integer>> groups = new LinkedHashMap<>();
    for (int i = 0; i < rows.size(); i++) {
      groups.computeIfAbsent(key.apply(rows.get(i)), newKey -> new ArrayList<>()).add(i);
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
