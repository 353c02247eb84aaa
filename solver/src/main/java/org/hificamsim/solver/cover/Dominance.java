package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.solver.BitMatrix;

/**
 * Finds the candidates that a plan may need. A candidate is dominated, and omitted, if it covers
 * nothing, or if enough others cover all its points at no higher price. Enough are as many as the
 * greatest number of times that covering a point counts.
 *
 * <p>Candidates are compared with all those kept so far at once: the sets of kept candidates that
 * cover each of its points are intersected, as words of bits.
 */
final class Dominance {
  /**
   * The number of points, spread over a candidate, that are compared first: most prove it needed.
   */
  private static final int FIRST_POINTS = 16;

  private final CoverInstance instance;
  private final int dominatorsNeeded;

  /** The kept candidates that cover a point, in the order in which they were kept, by point. */
  private BitMatrix keptByPoint;

  private int kept;

  private Dominance(CoverInstance instance) {
    this.instance = instance;
    this.dominatorsNeeded = Math.max(1, Arrays.stream(instance.needs()).max().orElse(1));
    this.keptByPoint = new BitMatrix(instance.points(), Long.SIZE);
  }

  /** Returns the candidates that are not dominated, in ascending order. */
  static int[] undominated(CoverInstance instance) {
    return new Dominance(instance).undominated();
  }

  private int[] undominated() {
    List<Integer> dominatorsFirst =
        IntStream.range(0, instance.candidates())
            .boxed()
            .filter(candidate -> instance.covered()[candidate].length > 0)
            .sorted(
                Comparator.<Integer>comparingDouble(candidate -> instance.prices()[candidate])
                    .thenComparingInt(candidate -> -instance.covered()[candidate].length))
            .toList();
    IntStream.Builder undominated = IntStream.builder();
    for (int candidate : dominatorsFirst) {
      if (!isDominated(instance.covered()[candidate])) {
        undominated.add(candidate);
        keep(instance.covered()[candidate]);
      }
    }
    return undominated.build().sorted().toArray();
  }

  private void keep(int[] points) {
    if (kept == Long.SIZE * keptByPoint.words()) {
      keptByPoint = keptByPoint.widened(2 * kept);
    }
    for (int point : points) {
      keptByPoint.set(point, kept);
    }
    kept++;
  }

  /** Whether enough of the candidates kept so far, which cost no more, cover all points. */
  private boolean isDominated(int[] points) {
    BitMatrix dominators = keptByPoint.row(points[0], Math.max(1, kept));
    int stride = Math.max(1, points.length / FIRST_POINTS);
    for (int i = 0; i < points.length; i += stride) {
      if (!dominators.intersect(0, keptByPoint, points[i])) {
        return false;
      }
    }
    for (int i = 1; i < points.length && stride > 1; i++) {
      if (!dominators.intersect(0, keptByPoint, points[i])) {
        return false;
      }
    }
    return dominators.count(0) >= dominatorsNeeded;
  }
}
